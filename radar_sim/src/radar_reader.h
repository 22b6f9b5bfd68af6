#pragma once

#include "radar_params.h"
#include "reading.h"

namespace radar_sim {

/// One entry of the scenario's list `radars`: a type and what differs from it.
RadarParams readRadar(ParameterReader& reader);

}  // namespace radar_sim
