#include "graph_lists.h"

#include <algorithm>
#include <set>

#include "recorded_requests.h"
#include "topic_name.h"

namespace tws_launch {
namespace {

/// A type without its package.
std::string bare(const std::string& type) { return lastPart(type); }

bool hears(const NodeDescription& node, const std::string& topic) {
  return std::count(node.hears.begin(), node.hears.end(), topic) > 0;
}

/// Its radars are on a ship, of which /tf tells where it is.
bool followsOwnShip(const NodeDescription& node) {
  const YAML::Node frame = node.parameters["own_ship_frame"];
  return frame && !frame.as<std::string>("").empty();
}

}  // namespace

std::vector<std::string> GraphLists::topicsOfType(const std::string& type) const {
  std::vector<std::string> topics;
  const auto add = [&](const std::map<std::string, std::string>& said) {
    for (const auto& [topic, its_type] : said)
      if ((its_type == type || bare(its_type) == type) && std::count(topics.begin(), topics.end(), topic) == 0)
        topics.push_back(topic);
  };
  add(sensor_topics_);
  for (const NodeDescription& node : graph_.nodes) add(node.says);
  return topics;
}

std::vector<std::string> GraphLists::namesOfType(const std::string& type) const {
  std::vector<std::string> names;
  for (const std::string& topic : topicsOfType(type)) {
    const std::string relative = relativeName(graph_.space, topic);
    if (lastPart(relative) == "tracks") names.push_back(spaceOf(relative));
  }
  return names;
}

std::vector<std::string> GraphLists::waitedFor(const std::string& but_of) const {
  std::set<std::string> said;  // each topic once, by however many nodes
  for (const NodeDescription& node : graph_.nodes)
    for (const auto& [topic, type] : node.says)
      // A tracker requests elevations of some radars only; their closed loop waits for itself.
      if (node.role != but_of && bare(type) != "ElevationRequests") said.insert(topic);
  std::vector<std::string> topics;
  for (const std::string& topic : said)
    for (const NodeDescription& node : graph_.nodes)
      if (hears(node, topic) || hears(node, whereItIs(topic))) topics.push_back(whereItIs(topic));
  return topics;
}

std::vector<std::string> GraphLists::played() const {
  std::set<std::string> heard{"/tf_static"};
  for (const NodeDescription& node : graph_.nodes) {
    heard.insert(node.hears.begin(), node.hears.end());
    if (followsOwnShip(node)) heard.insert("/tf");
  }
  heard.erase("/diagnostics");  // It is of the run that was recorded.
  std::set<std::string> topics;
  for (const std::string& topic : heard) {
    const auto found = input_.topics.find(whereItIs(topic));
    if (found != input_.topics.end() && !isSaidHere(topic)) topics.insert(found->second);
  }
  return {topics.begin(), topics.end()};
}

/// By a tracker or watcher, which says it anew.
bool GraphLists::isSaidHere(const std::string& topic) const {
  return std::any_of(graph_.nodes.begin(), graph_.nodes.end(),
                     [&](const NodeDescription& node) { return node.role != "source" && node.says.count(topic) > 0; });
}

std::vector<std::string> GraphLists::recorded() const {
  std::vector<std::string> topics;
  for (const bool of_source : {false, true})
    for (const NodeDescription& node : graph_.nodes)
      for (const auto& [topic, type] : node.says)
        if ((node.role == "source") == of_source) topics.push_back(whereItIs(topic));
  topics.insert(topics.end(), {"/diagnostics", "/tf", "/tf_static"});
  return topics;
}

std::vector<std::string> GraphLists::requests() const {
  std::vector<std::string> topics;
  for (const NodeDescription& node : graph_.nodes)
    if (repeatsRequests(node)) topics.push_back(requestsTo(node));
  return topics;
}

std::map<std::string, std::string> GraphLists::requestRemaps() const {
  std::map<std::string, std::string> remaps;
  for (const NodeDescription& node : graph_.nodes)
    if (repeatsRequests(node)) remaps[requestsTo(node)] = resolvedName(graph_.space, node.name + "/recorded_requests");
  return remaps;
}

std::string GraphLists::requestsTo(const NodeDescription& node) const {
  return requestTopic(input_, graph_.space, node.name)
      .value_or(resolvedName(graph_.space, node.name + "/operator_requests"));
}

std::string GraphLists::whereItIs(const std::string& topic) const {
  const auto remapped = graph_.remaps.find(topic);
  return remapped == graph_.remaps.end() ? topic : remapped->second;
}

}  // namespace tws_launch
