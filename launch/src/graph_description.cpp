#include "graph_description.h"

#include <tws_runtime/parameters.h>

#include <algorithm>
#include <regex>
#include <sstream>
#include <stdexcept>

namespace tws_launch {
namespace {

/// Numbers and truth values of which YAML 1.1 (rosparam) and 1.2 (yaml-cpp) think the same stay bare; all else is text.
/// Whole numbers of more than nine digits do not fit into a ROS parameter.
bool staysBare(const YAML::Node& scalar) {
  static const std::regex kBare("true|false|-?[0-9]{1,9}|-?[0-9]+\\.[0-9]*([eE][-+][0-9]+)?");
  return scalar.Tag() != "!" && std::regex_match(scalar.Scalar(), kBare) &&
         !(scalar.Scalar().size() > 1 && scalar.Scalar()[0] == '0' && scalar.Scalar()[1] != '.');
}

std::string quoted(const std::string& text) {
  YAML::Emitter emitter;
  emitter << YAML::DoubleQuoted << text;
  return emitter.c_str();
}

std::string scalarText(const YAML::Node& scalar) {
  return staysBare(scalar) ? scalar.Scalar() : quoted(scalar.Scalar());
}

std::map<std::string, std::string> textMap(const YAML::Node& node) {
  return node ? node.as<std::map<std::string, std::string>>() : std::map<std::string, std::string>();
}

NodeDescription nodeFromYaml(const YAML::Node& entry) {
  NodeDescription node;
  node.package = entry["package"].as<std::string>();
  node.type = entry["type"].as<std::string>();
  node.name = entry["name"].as<std::string>();
  node.role = entry["role"].as<std::string>("tracker");
  node.remaps = textMap(entry["remaps"]);
  node.parameters = entry["parameters"];
  return node;
}

void write(std::ostream& out, const NodeDescription& node) {
  out << "- package: " << quoted(node.package) << "\n  type: " << quoted(node.type) << "\n  name: " << quoted(node.name)
      << "\n  role: " << node.role << "\n";
  if (!node.remaps.empty()) out << "  remaps: " << inOneLine(YAML::Node(node.remaps)) << "\n";
  if (!node.parameters.IsMap() || node.parameters.size() == 0) return;
  out << "  parameters:\n";
  for (const auto& entry : node.parameters)
    out << "    " << scalarText(entry.first) << ": " << inOneLine(entry.second) << "\n";
}

}  // namespace

const NodeDescription* GraphDescription::find(const std::string& name) const {
  const auto found = std::find_if(nodes.begin(), nodes.end(), [&](const auto& node) { return node.name == name; });
  return found == nodes.end() ? nullptr : &*found;
}

std::string inOneLine(const YAML::Node& tree) {
  if (tree.IsScalar()) return scalarText(tree);
  std::string text;
  if (tree.IsMap()) {
    for (const auto& entry : tree)
      text += (text.empty() ? "" : ", ") + scalarText(entry.first) + ": " + inOneLine(entry.second);
    return "{" + text + "}";
  }
  for (const YAML::Node& entry : tree) text += (text.empty() ? "" : ", ") + inOneLine(entry);
  return tree.IsSequence() ? "[" + text + "]" : "null";
}

std::string toYaml(const GraphDescription& graph) {
  std::ostringstream out;
  out << "namespace: " << quoted(graph.space) << "\nsensors: " << inOneLine(YAML::Node(graph.sensors))
      << "\nremaps: " << inOneLine(YAML::Node(graph.remaps)) << "\nnodes:\n";
  for (const NodeDescription& node : graph.nodes)
    if (node.arguments.empty()) write(out, node);
  return out.str();
}

GraphDescription graphFromYaml(const std::string& yaml) try {
  const YAML::Node tree = tws_runtime::parseParameters(yaml, "text");
  GraphDescription graph;
  graph.space = tree["namespace"].as<std::string>("");
  if (tree["sensors"]) graph.sensors = tree["sensors"].as<Sensors>();
  graph.remaps = textMap(tree["remaps"]);
  for (const YAML::Node& entry : tree["nodes"]) graph.nodes.push_back(nodeFromYaml(entry));
  return graph;
} catch (const std::runtime_error& error) {
  throw std::runtime_error(std::string("is no description of a graph: ") + error.what());
}

}  // namespace tws_launch
