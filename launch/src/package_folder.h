#pragma once

#include <string>

namespace tws_launch {

/// The folder of a ROS package. Throws std::runtime_error when it is not found.
std::string packageFolder(const std::string& package);

}  // namespace tws_launch
