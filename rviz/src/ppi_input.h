#pragma once

#include <geometry_msgs/Transform.h>
#include <tws_msgs/ClutterMap.h>
#include <tws_msgs/CorrelatedTrack.h>
#include <tws_msgs/Detection.h>
#include <tws_msgs/RadarMap.h>
#include <tws_msgs/RadarRegistration.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/SsrPlot.h>
#include <tws_msgs/Track.h>
#include <tws_msgs/TruthTarget.h>

#include <string>

#include "fading_detections.h"
#include "identities.h"
#include "planar_frame.h"
#include "radar_cells.h"
#include "sweep.h"
#include "track_picture.h"

namespace tws_rviz {

// From messages to what is drawn. All throw std::invalid_argument that names the field when a message makes no sense.

PlanarFrame planarFrame(const geometry_msgs::Transform& transform);

BeamMark beamMark(const tws_msgs::SectorMark& mark);

/// The slant range is laid on the ground, as on every PPI.
PlotMark plotMark(const tws_msgs::Detection& detection, const PlanarFrame& site);

/// Throws std::invalid_argument also when there are not as many values as cells.
RadarCells radarCells(const tws_msgs::RadarMap& map, const PlanarFrame& site);

Eigen::Vector2d clutterPosition(const tws_msgs::ClutterPoint& point, const PlanarFrame& site);

Eigen::Vector2d truthPosition(const tws_msgs::TruthTarget& target, const PlanarFrame& frame);

/// `source`, `prefix`: which tracker, and what stands before its numbers. `published`: stamp of the Tracks message [s].
TrackReport trackReport(const tws_msgs::Track& track, std::size_t source, const std::string& prefix, double published,
                        const PlanarFrame& frame);

/// Named by the correlator's own identity.
TrackReport trackReport(const tws_msgs::CorrelatedTrack& track, std::size_t source, double published,
                        const PlanarFrame& frame);

IdentityPlot identityPlot(const tws_msgs::SsrPlot& plot, const PlanarFrame& site);

/// What is taken out of a radar's plots, e.g. "+40 m +0.15 deg -0.30 s", or why nothing is; empty: there is nothing to
/// say.
std::string alignmentText(const tws_msgs::RadarRegistration& radar);

/// Mode 3/A code in octal and flight level, as far as known, e.g. "4271 F350"; empty: neither.
std::string identityText(const tws_msgs::Track& track);
/// The same after the callsign, if known.
std::string identityText(const tws_msgs::SsrPlot& plot);

}  // namespace tws_rviz
