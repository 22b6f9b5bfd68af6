#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <string>
#include <vector>

namespace tws_launch {

/// One node of a graph, as roslaunch or the offline runner starts it.
struct NodeDescription {
  std::string package;
  std::string type;  ///< The program.
  std::string name;  ///< In the graph's namespace, e.g. "adit".
  std::string role;  ///< source, tracker, watcher or recorder; see graph.yaml.
  YAML::Node parameters;
  std::map<std::string, std::string> remaps;  ///< From absolute name to absolute name.
  std::vector<std::string> arguments;         ///< On the command line.
  std::string prefix;                         ///< roslaunch's launch-prefix.
  bool respawn = false;                       ///< Is started again when it dies; else that ends the run of a tracker.
  bool quiet = false;                         ///< What it prints is only logged.
  std::vector<std::string> hears;             ///< Topics, absolute.
  std::map<std::string, std::string> says;    ///< The same, and their types.

  std::string program() const { return package + "/" + type; }
};

/// The names of an input's sensors, by kind (see graph.yaml), in the order in which trackers number them.
using Sensors = std::map<std::string, std::vector<std::string>>;

/// A whole graph: what roslaunch's XML, the offline runner and the record in a bag are made from.
struct GraphDescription {
  std::string space;  ///< The namespace: "" or e.g. "/ship".
  Sensors sensors;
  std::map<std::string, std::string> remaps;  ///< Of all nodes: where a sensor's topic has another name than usual.
  std::vector<NodeDescription> nodes;
  bool nodelets = false;  ///< Live, in one manager, as far as they are nodelets.

  /// Null when there is none of that name.
  const NodeDescription* find(const std::string& name) const;
};

/// The description as YAML, as it is recorded: nodes with all their parameters. Those of a live run only are left out.
std::string toYaml(const GraphDescription& graph);
/// Reads that again. Throws std::runtime_error when it is none.
GraphDescription graphFromYaml(const std::string& yaml);

/// A tree of parameters in one line of YAML that every reader of YAML 1.1 and 1.2 takes for the same.
std::string inOneLine(const YAML::Node& tree);

}  // namespace tws_launch
