#pragma once

#include <tws_core/range_rate.h>

#include "core/radar_state.h"

namespace adit_tracker {

// What the range rate that comes with a plot adds to log-likelihoods that are compared with those of false plots; 0
// without one.

/// Of a target whose rate was foreseen: the filter has its part, this is the false plots'.
double againstFalse(const tws::RangeRate& rate, const RadarQuality& quality);

/// Of what does not move. It may drift, as rain does, or turn, as rotors do, and then show any rate.
double standingAgainstFalse(const tws::RangeRate& rate, const RadarQuality& quality);

}  // namespace adit_tracker
