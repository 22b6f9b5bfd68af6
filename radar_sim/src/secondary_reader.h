#pragma once

#include "radar_params.h"
#include "reading.h"
#include "secondary_params.h"

namespace radar_sim {

/// One entry of the scenario's list `secondary_radars`. `radars`: those on whose masts it may turn.
SecondaryParams readSecondaryRadar(ParameterReader& reader, const std::vector<RadarParams>& radars);

}  // namespace radar_sim
