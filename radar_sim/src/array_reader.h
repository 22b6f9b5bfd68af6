#pragma once

#include "array_params.h"
#include "reading.h"

namespace radar_sim {

/// One entry of the scenario's list `array_radars`.
ArrayParams readArrayRadar(ParameterReader& reader);

}  // namespace radar_sim
