#pragma once

#include <tws_runtime/parameters.h>

#include "mfa_stub_params.h"

namespace esa_frame_builder {

/// Reads the tracker's own keys and leaves the others. Throws tws_runtime::ParameterError.
MfaStubParams readMfaStubParams(tws_runtime::ParameterReader& reader);

}  // namespace esa_frame_builder
