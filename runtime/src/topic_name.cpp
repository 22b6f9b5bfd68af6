#include "topic_name.h"

#include <ros/names.h>

#include <stdexcept>

namespace tws_runtime {

std::string absoluteName(const std::string& node, const std::string& name) {
  std::string reason;
  if (name.empty() || name[0] == '~' || !ros::names::validate(name, reason))
    throw std::invalid_argument(node + ": '" + name + "' is no topic or service name");
  return ros::names::clean(name[0] == '/' ? name : "/" + node + "/" + name);
}

}  // namespace tws_runtime
