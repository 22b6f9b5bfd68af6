#pragma once

#include <tws_runtime/parameters.h>

#include "window_params.h"

namespace range_gate_tracker {

/// Reads what concerns the tracker; the caller reads the rest, calls done() and check(). Throws
/// tws_runtime::ParameterError.
WindowParams readWindowParams(tws_runtime::ParameterReader& reader);

}  // namespace range_gate_tracker
