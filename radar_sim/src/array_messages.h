#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include <tws_msgs/DwellReports.h>
#include <tws_msgs/TrackDatabase.h>

#include "array_radar.h"

namespace radar_sim {

/// The message of one resource period of `array`, whose frame has the array's name.
tws_msgs::DwellReports toDwellReports(const ResourcePeriod& period, const ArrayParams& array);

/// The tracks of a database, whose positions may stand in the map's frame or in the array's. Throws
/// std::invalid_argument that names the field when it is of another radar or frame, or holds a number that makes no
/// sense.
std::vector<ArrayTrack> toArrayTracks(const tws_msgs::TrackDatabase& database, const std::string& array,
                                      const Eigen::Isometry3d& map_to_array);

}  // namespace radar_sim
