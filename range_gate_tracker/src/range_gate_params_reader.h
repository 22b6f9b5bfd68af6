#pragma once

#include <tws_runtime/parameters.h>

#include "range_gate_params.h"

namespace range_gate_tracker {

/// Reads and checks the keys of config/aircraft.yaml that are the tracker's own. Throws ParameterError.
RangeGateParams readRangeGateParams(tws_runtime::ParameterReader& reader);

}  // namespace range_gate_tracker
