#pragma once

#include <geometry_msgs/TransformStamped.h>

#include <Eigen/Geometry>
#include <string>

#include <tws_msgs/RangeProfile.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Truth.h>

#include "simulation.h"

namespace radar_sim {

/// The frame of the scenario's map.
constexpr const char* kMapFrame = "map";

/// Messages of what a simulation reports. A radar's frame has the radar's name.
tws_msgs::SectorMark toSectorMark(const SectorReport& report, const Simulation& simulation);
tws_msgs::SectorMark toSectorMark(const SecondarySectorReport& report, const Simulation& simulation);
tws_msgs::SsrPlots toSsrPlots(const SecondarySector& sector, const std::string& radar);
tws_msgs::RangeProfile toRangeProfile(const AmplitudeProfile& profile, const RangeRadarParams& radar);
tws_msgs::Truth toTruth(const TruthReport& report, const Simulation& simulation);

/// The pose of the radar's frame in the map.
geometry_msgs::TransformStamped toTransform(const Eigen::Isometry3d& map_to_radar, const std::string& radar);

}  // namespace radar_sim
