#pragma once

#include <tws_msgs/ClutterMap.h>
#include <tws_msgs/Track.h>

#include "adit.h"

namespace adit_tracker {

/// What the tracker says of a track; the radars' site is at (east, north) in the frame of positions [m].
tws_msgs::Track trackMessage(const Adit& adit, const TrackWord& word, double east, double north);

/// The clutter map without its header.
tws_msgs::ClutterMap clutterMessage(const Adit& adit);

}  // namespace adit_tracker
