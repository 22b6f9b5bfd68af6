#pragma once

#include <string>

namespace tws_runtime {

/// The absolute name of a topic or service that `node` (no leading slash) calls `name`: absolute already, or the node's
/// own. Throws std::invalid_argument when it is no ROS graph name.
std::string absoluteName(const std::string& node, const std::string& name);

}  // namespace tws_runtime
