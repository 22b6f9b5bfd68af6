#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <string>
#include <vector>

namespace tws_launch {

/// One node of a launch file, as roslaunch would start it.
struct NodeDescription {
  std::string package;
  std::string type;  ///< The executable.
  std::string name;  ///< Without a leading slash.
  std::map<std::string, std::string> remaps;
  YAML::Node parameters;
};

/// The nodes of a launch file of this package, resolved by roslaunch's own loader. `arguments` are "name:=value".
/// Throws std::runtime_error when roslaunch refuses the file; what it said is on the standard error.
std::vector<NodeDescription> describeGraph(const std::string& launch_file, const std::vector<std::string>& arguments);

/// Reads the list of nodes that scripts/describe_graph prints. Throws YAML::Exception.
std::vector<NodeDescription> parseGraph(const std::string& yaml);

}  // namespace tws_launch
