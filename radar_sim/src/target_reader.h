#pragma once

#include "reading.h"

namespace radar_sim {

/// One entry of the scenario's list `targets`.
Target readTarget(ParameterReader& reader, const ReadingContext& context);

/// One entry of `clutter`: a point that stays where it is.
Target readClutterPoint(ParameterReader& reader, const ReadingContext& context);

/// One entry of `random_aircraft`, `random_clutter` or `random_slow_movers`.
RandomGroup readGroup(ParameterReader& reader, TargetKind kind, const ReadingContext& context);

}  // namespace radar_sim
