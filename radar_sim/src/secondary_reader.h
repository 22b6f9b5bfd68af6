#pragma once

#include "radar_params.h"
#include "reading.h"
#include "secondary_params.h"

namespace radar_sim {

/// One entry of the scenario's list `secondary_radars`. `radars`: those on whose masts it may turn. `start_time` of the
/// scenario [s].
SecondaryParams readSecondaryRadar(ParameterReader& reader, const std::vector<RadarParams>& radars, double start_time);

}  // namespace radar_sim
