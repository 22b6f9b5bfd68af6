#pragma once

#include <tws_runtime/parameters.h>

#include "correlator.h"

namespace track_correlator {

/// Reads and checks the keys of config/track_correlator.yaml that are the correlator's own. Throws ParameterError.
CorrelatorParams readCorrelatorParams(tws_runtime::ParameterReader& reader);

}  // namespace track_correlator
