#pragma once

#include <tws_msgs/RadarMap.h>

#include <cstddef>

#include "core/adit.h"

namespace adit_tracker {

/// What the tracker has learned of a radar (index in params.radars), to the farthest plot; without its header.
tws_msgs::RadarMap radarMapMessage(const Adit& adit, std::size_t radar);

}  // namespace adit_tracker
