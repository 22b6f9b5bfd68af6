#pragma once

#include <string>
#include <vector>

#include <tws_core/sea_level.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_msgs/Track.h>
#include <tws_runtime/conversions.h>

#include "secondary_tracker.h"

namespace track_correlator {

using tws_runtime::Site;

/// A message's sector. Plots without a usable position or time are left out, codes and heights out of range become
/// unknown; `faults` gets a line for each.
SecondarySector sectorOf(const tws_msgs::SsrPlots& message, std::vector<std::string>& faults);

/// What the tracker says of a track. With a known height the position lies at that height above the sea, without one
/// the slant range is laid on the ground.
tws_msgs::Track trackMessage(const SecondaryUpdate& update, const Site& site, const tws::SeaLevel& sea,
                             const std::string& radar);

}  // namespace track_correlator
