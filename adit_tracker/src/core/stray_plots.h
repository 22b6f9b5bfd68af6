#pragma once

#include <cstdint>

#include "core/radar_state.h"
#include "core/track.h"

namespace adit_tracker {

/// What lies near a firm track that was not detected may be its target's after all, by a gross error of the radar or a
/// manoeuvre beyond all measure: those detections in the sectors around the running one are less likely a new target's
/// (Detection::fresh). Else a precise radar's stray plot starts a second track, which takes over the aircraft.
void suspectStrays(const Track& track, RadarState& radar, std::int64_t running);

}  // namespace adit_tracker
