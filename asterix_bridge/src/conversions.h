#pragma once

#include <string>

#include <geometry_msgs/TransformStamped.h>
#include <tws_core/geodesy.h>
#include <tws_core/plot.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/SsrPlots.h>

#include "sector_cutter.h"

namespace asterix_bridge {

/// The plots of a sector. `primary_only`: those that the primary radar has detected, where it saw them (the SSR's
/// position and the difference that I048/130 tells); else all, as reported.
tws::RadarSector toRadarSector(const CutSector& sector, bool primary_only);

/// The replies of a sector to the secondary radar. A code or level that is not validated is unknown.
tws_msgs::SsrPlots toSsrPlots(const CutSector& sector, const std::string& radar);

/// The mark at the end of a sector with so many detections; `running_count` of them since the start.
tws_msgs::SectorMark toSectorMark(const CutSector& sector, const std::string& radar, std::size_t count,
                                  std::uint32_t running_count);

/// The frame of a radar's site in the map: east, north, up there.
geometry_msgs::TransformStamped toTransform(const tws::LocalFrame& map, const tws::Geodetic& site,
                                            const std::string& frame, const std::string& radar);
/// A site at the map's origin.
geometry_msgs::TransformStamped atOrigin(const std::string& frame, const std::string& radar);

}  // namespace asterix_bridge
