#pragma once

#include <tws_msgs/ClutterMap.h>
#include <tws_msgs/PlotFates.h>
#include <tws_msgs/Track.h>
#include <tws_runtime/conversions.h>

#include "core/adit.h"

namespace adit_tracker {

using tws_runtime::Site;

/// What positions of the tracker are counted from: the first radar's site, or where own ship is by now.
Site originOf(const Adit& adit, const Site& site);

/// What the tracker says of a track: range and azimuth as the radars see it, position and velocity in the frame of
/// positions.
tws_msgs::Track trackMessage(const Adit& adit, const TrackUpdate& update, const Site& site);

/// What became of a sector's plots; header.stamp, too.
tws_msgs::PlotFates fatesMessage(const Adit& adit, const SectorFates& sector);

/// The clutter map without its header.
tws_msgs::ClutterMap clutterMessage(const Adit& adit);

}  // namespace adit_tracker
