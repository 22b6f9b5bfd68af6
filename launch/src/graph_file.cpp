#include "graph_file.h"

#include <tws_runtime/parameters.h>

#include <algorithm>
#include <set>
#include <stdexcept>

#include "package_folder.h"

namespace tws_launch {
namespace {

using tws_runtime::ParameterReader;

const std::set<std::string> kNodeKeys{"args",       "beneath", "draw",    "files", "hears",  "name",
                                      "parameters", "prefix",  "program", "quiet", "remaps", "respawn",
                                      "role",       "run",     "says",    "sign",  "when"};

SensorKind readKind(ParameterReader reader, const std::string& name) {
  SensorKind kind;
  kind.name = name;
  reader.require("topics");
  ParameterReader topics = reader.map("topics");
  for (const std::string& part : topics.keys()) {
    std::string type;
    topics.text(part, type);
    kind.topics.emplace_back(part, type);
  }
  reader.texts("order", kind.order);
  reader.texts("only", kind.only);
  reader.flag("primary", kind.primary);
  topics.done();
  reader.done();
  return kind;
}

NodeRow readRow(ParameterReader reader, const YAML::Node& row) {
  NodeRow node;
  for (const std::string& key : reader.keys())
    if (kNodeKeys.count(key) == 0) reader.fail(key, "is no key of a node");
  for (const char* key : {"name", "program", "role"}) reader.require(key);
  reader.text("name", node.name);
  reader.text("program", node.program);
  reader.choice("role", node.role, {"source", "tracker", "watcher", "recorder"});
  reader.text("when", node.when);
  if (node.program.find('/') == std::string::npos) reader.fail("program", "is PACKAGE/PROGRAM");
  node.row = row;
  return node;
}

}  // namespace

bool SensorKind::takes(const std::string& name) const {
  return only.empty() || std::count(only.begin(), only.end(), name) > 0;
}

std::vector<std::string> SensorKind::ordered(std::vector<std::string> names) const {
  const auto place = [this](const std::string& name) { return std::find(order.begin(), order.end(), name); };
  std::sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return std::make_pair(place(a), a) < std::make_pair(place(b), b);
  });
  return names;
}

const NodeRow* GraphFile::find(const std::string& name) const {
  const auto found = std::find_if(nodes.begin(), nodes.end(), [&](const NodeRow& row) { return row.name == name; });
  return found == nodes.end() ? nullptr : &*found;
}

const SensorKind& GraphFile::kind(const std::string& name) const {
  const auto found = std::find_if(sensors.begin(), sensors.end(), [&](const auto& kind) { return kind.name == name; });
  if (found == sensors.end()) throw std::runtime_error("graph.yaml has no kind of sensor '" + name + "'");
  return *found;
}

GraphFile readGraphFile(const std::string& path) {
  const std::string file = path.empty() ? packageFolder("tws_launch") + "/graph.yaml" : path;
  const YAML::Node tree = tws_runtime::loadParameterFile(file);
  ParameterReader reader(tree, file);
  GraphFile graph;
  ParameterReader kinds = reader.map("sensors");
  for (const std::string& name : kinds.keys()) graph.sensors.push_back(readKind(kinds.map(name), name));
  std::size_t number = 0;
  for (const ParameterReader& row : reader.list("nodes")) graph.nodes.push_back(readRow(row, tree["nodes"][number++]));
  kinds.done();
  reader.done();
  return graph;
}

GraphFile readGraphFileWith(const std::string& more) {
  GraphFile graph = readGraphFile();
  if (more.empty()) return graph;
  const GraphFile added = readGraphFile(more);
  graph.sensors.insert(graph.sensors.end(), added.sensors.begin(), added.sensors.end());
  graph.nodes.insert(graph.nodes.end(), added.nodes.begin(), added.nodes.end());
  return graph;
}

}  // namespace tws_launch
