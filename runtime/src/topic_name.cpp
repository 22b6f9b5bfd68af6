#include "topic_name.h"

#include <ros/names.h>

#include <stdexcept>

namespace tws_runtime {

std::string absoluteName(const std::string& node, const std::string& name) {
  std::string reason;
  if (name.empty() || name == "~" || !ros::names::validate(name, reason))
    throw std::invalid_argument(node + ": '" + name + "' is no topic or service name");
  if (name[0] == '/') return ros::names::clean(name);
  if (name[0] == '~') return ros::names::clean("/" + node + "/" + name.substr(1));
  const std::size_t slash = node.rfind('/');
  const std::string space = slash == std::string::npos ? "" : "/" + node.substr(0, slash);
  return ros::names::clean(space + "/" + name);
}

}  // namespace tws_runtime
