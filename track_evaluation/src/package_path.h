#pragma once

#include <string>

namespace track_evaluation {

/// The folder that holds this package's config, in the source or the install space. Throws std::runtime_error when ROS
/// does not know the package.
std::string packagePath();

}  // namespace track_evaluation
