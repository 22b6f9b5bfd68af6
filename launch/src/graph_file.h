#pragma once

#include <yaml-cpp/yaml.h>

#include <string>
#include <utility>
#include <vector>

namespace tws_launch {

/// A kind of sensor: see graph.yaml.
struct SensorKind {
  std::string name;
  std::vector<std::pair<std::string, std::string>> topics;  ///< Last part of the name, and type; the first one tells.
  std::vector<std::string> order;                           ///< These first.
  std::vector<std::string> only;                            ///< Only these names are such sensors; empty: any.
  bool primary = false;                                     ///< A run needs one of these.

  bool takes(const std::string& name) const;
  /// Names in the order in which trackers number them: those of `order` first, then by name.
  std::vector<std::string> ordered(std::vector<std::string> names) const;
};

/// A node's row in graph.yaml.
struct NodeRow {
  std::string name, program, role;
  std::string when;  ///< Condition.
  YAML::Node row;    ///< With all other keys.

  std::string package() const { return program.substr(0, program.find('/')); }
  std::string type() const { return program.substr(program.find('/') + 1); }
  YAML::Node operator[](const std::string& key) const { return row[key]; }
};

/// graph.yaml: the kinds of sensors and all nodes.
struct GraphFile {
  std::vector<SensorKind> sensors;
  std::vector<NodeRow> nodes;

  /// Null when no row has that name.
  const NodeRow* find(const std::string& name) const;
  /// Throws std::runtime_error when there is none.
  const SensorKind& kind(const std::string& name) const;
};

/// Reads a file like graph.yaml; empty: that of this package. Throws tws_runtime::ParameterError.
GraphFile readGraphFile(const std::string& path = "");
/// That of this package with the nodes of another file of the same form besides, whose sensors may be left out; empty:
/// none. Throws tws_runtime::ParameterError.
GraphFile readGraphFileWith(const std::string& more);

}  // namespace tws_launch
