#pragma once

#include <string>

namespace tws_runtime {

/// The absolute name of a topic or service that `node` calls `name`, by ROS's rules: "/x" is absolute, "~x" is the
/// node's own, "x" belongs to the node's namespace. `node` has no leading slash: "adit", or "siteA/adit" in namespace
/// /siteA. Throws std::invalid_argument when `name` is no ROS graph name.
std::string absoluteName(const std::string& node, const std::string& name);

}  // namespace tws_runtime
