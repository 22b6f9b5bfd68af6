#pragma once

#include "range_radar_params.h"
#include "reading.h"

namespace radar_sim {

/// One entry of the scenario's list `range_radars`. Whether its target exists is for the caller to check.
RangeRadarParams readRangeRadar(ParameterReader& reader);

}  // namespace radar_sim
