#include "package_path.h"

#include <ros/package.h>

#include <stdexcept>

namespace track_evaluation {

std::string packagePath() {
  const std::string path = ros::package::getPath("track_evaluation");
  if (path.empty())
    throw std::runtime_error("package track_evaluation is not found: source setup.bash, or name the files");
  return path;
}

}  // namespace track_evaluation
