#pragma once

#include "node_registry.h"

namespace tws_launch {

/// The whole of tws_offline's main(), with these nodes. Returns the exit status.
int offlineMain(int argc, char** argv, const NodeRegistry& registry);

}  // namespace tws_launch
