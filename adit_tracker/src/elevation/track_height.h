#pragma once

#include <tws_msgs/Track.h>

#include "elevation/height_file.h"
#include "io/track_messages.h"

namespace adit_tracker {

/// Puts a track to its height: elevation, height, z, and where its slant range was `laid_flat` on the plane, position,
/// velocity and covariance over the ground. Without a place at that slant range and height the message stays as it is.
void setHeight(tws_msgs::Track& message, const Height& height, const Site& site, bool laid_flat = true);

}  // namespace adit_tracker
