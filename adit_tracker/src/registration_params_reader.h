#pragma once

#include <vector>

#include <tws_core/registration.h>
#include <tws_runtime/parameters.h>

#include "adit_params.h"

namespace adit_tracker {

/// Reads the block `registration` of config/default.yaml; keys that are absent change nothing, but of a list of
/// references, which counts whole. Throws tws_runtime::ParameterError.
void readRegistrationParams(tws_runtime::ParameterReader reader, tws::RegistrationParams& params,
                            std::vector<RegistrationReference>& references);

}  // namespace adit_tracker
