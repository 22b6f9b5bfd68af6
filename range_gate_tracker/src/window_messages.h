#pragma once

#include <tws_msgs/Track.h>
#include <tws_msgs/TrackWindow.h>
#include <tws_runtime/conversions.h>

#include <Eigen/Core>
#include <string>

#include "window_tracker.h"

namespace range_gate_tracker {

/// What the tracker says of a track: a measured one stands where it was detected, a missed one where it is expected
/// now.
tws_msgs::Track trackMessage(const WindowTracker& tracker, const WindowUpdate& update, const tws_runtime::Site& site,
                             const std::string& radar);

/// Its track file.
tws_msgs::TrackWindow windowMessage(const WindowUpdate& update);

/// A place in the frame of positions, as seen from the radar: x east, y north [m].
Eigen::Vector2d fromSite(double x, double y, const tws_runtime::Site& site);
/// And back.
Eigen::Vector2d toFrame(const Eigen::Vector2d& place, const tws_runtime::Site& site);

}  // namespace range_gate_tracker
