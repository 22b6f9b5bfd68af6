#include "topic_name.h"

#include <ros/names.h>

#include <stdexcept>

namespace tws_launch {

std::string resolvedName(const std::string& space, const std::string& name) {
  std::string reason;
  if (name.empty() || name[0] == '~' || !ros::names::validate(name, reason))
    throw std::runtime_error("'" + name + "' is no name in ROS");
  return ros::names::clean(name[0] == '/' ? name : "/" + space + "/" + name);
}

std::string spaceOf(const std::string& name) { return name.substr(0, name.rfind('/')); }

std::string lastPart(const std::string& name) { return name.substr(name.rfind('/') + 1); }

std::string relativeName(const std::string& space, const std::string& name) {
  const std::string beginning = resolvedName("", space.empty() ? "/" : space);
  const std::string prefix = beginning == "/" ? "/" : beginning + "/";
  return name.compare(0, prefix.size(), prefix) == 0 ? name.substr(prefix.size()) : name;
}

}  // namespace tws_launch
