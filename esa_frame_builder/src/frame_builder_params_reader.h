#pragma once

#include <tws_runtime/parameters.h>

#include "frame_builder_params.h"

namespace esa_frame_builder {

/// Reads the frame builder's own keys and leaves the others. Throws tws_runtime::ParameterError.
FrameBuilderParams readFrameBuilderParams(tws_runtime::ParameterReader& reader);

}  // namespace esa_frame_builder
