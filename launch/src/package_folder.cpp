#include "package_folder.h"

#include <ros/package.h>

#include <stdexcept>

namespace tws_launch {

std::string packageFolder(const std::string& package) {
  std::string folder = ros::package::getPath(package);
  if (folder.empty()) throw std::runtime_error("package " + package + " is not found: source setup.bash");
  return folder;
}

}  // namespace tws_launch
