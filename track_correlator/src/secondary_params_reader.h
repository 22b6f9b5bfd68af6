#pragma once

#include <tws_runtime/parameters.h>

#include "secondary_params.h"

namespace track_correlator {

/// Reads and checks the keys of config/ssr_tracker.yaml that are the tracker's own. Throws ParameterError.
SecondaryParams readSecondaryParams(tws_runtime::ParameterReader& reader);

}  // namespace track_correlator
