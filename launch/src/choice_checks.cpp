#include "choice_checks.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "in_words.h"

namespace tws_launch {
namespace {

std::vector<std::string> namesOfTrackers(const GraphFile& file) {
  std::vector<std::string> names;
  for (const NodeRow& row : file.nodes)
    if (row.role == "tracker") names.push_back(row.name);
  return names;
}

}  // namespace

void refuseUnknownChoices(const GraphFile& file, const TrackerChoices& chosen) {
  for (const auto& [name, choice] : chosen) {
    const std::string& row = choice.like.empty() ? name : choice.like;
    if (!file.find(row))
      throw std::runtime_error("trackers: there is no node '" + row + "' (nodes: " + joined(namesOfTrackers(file)) +
                               ")");
  }
}

void refuseIdleChoices(const GraphFile& file, const GraphDescription& graph, const TrackerChoices& chosen) {
  for (const auto& [name, choice] : chosen)
    if (choice.on.value_or(true) && !graph.find(name))
      throw std::runtime_error("trackers: " + name +
                               " is no part of the graph of this input: it is one where there is '" +
                               file.find(choice.like.empty() ? name : choice.like)->when + "'");
}

void refuseUnknownRadars(const GraphFile& file, const RunInput& input, const GraphDescription& graph,
                         const TrackerChoices& chosen) {
  for (const NodeDescription& node : graph.nodes) {
    const auto choice = chosen.find(node.name);
    if (choice == chosen.end() || !choice->second.parameters.IsMap()) continue;
    const YAML::Node radar = choice->second.parameters["radar"];
    if (!radar || !radar.IsScalar()) continue;
    const auto has = [&](const SensorKind& kind) {
      const std::vector<std::string> names = input.names(kind.name);
      return std::count(names.begin(), names.end(), radar.Scalar()) > 0;
    };
    if (std::none_of(file.sensors.begin(), file.sensors.end(), has))
      throw std::runtime_error("trackers: " + node.name + "/radar: there is no radar '" + radar.Scalar() + "'");
  }
}

void refuseTwoOnOneTopic(const GraphDescription& graph) {
  std::map<std::string, std::string> speakers;
  for (const NodeDescription& node : graph.nodes)
    for (const auto& [topic, type] : node.says) {
      if (node.role != "tracker" || type == "tws_msgs/ElevationRequests") continue;
      const auto [other, is_new] = speakers.emplace(topic, node.name);
      if (!is_new)
        throw std::runtime_error("trackers: " + other->second + " and " + node.name + " both publish " + topic +
                                 "; one more of this node cannot run beside it");
    }
}

}  // namespace tws_launch
