#include "offline_graph.h"

#include <algorithm>
#include <stdexcept>

#include "topic_name.h"

namespace tws_launch {

OfflineGraph::OfflineGraph(const GraphDescription& graph, std::ostream& log, const NodeRegistry& registry)
    : log_(log), graph_(log) {
  for (const NodeDescription& node : graph.nodes) add(node, graph, registry);
}

void OfflineGraph::add(const NodeDescription& node, const GraphDescription& graph, const NodeRegistry& registry) {
  std::map<std::string, std::string> remaps = graph.remaps;
  remaps.insert(node.remaps.begin(), node.remaps.end());
  tws_runtime::Bus& bus = graph_.addNode(resolvedName(graph.space, node.name).substr(1), node.parameters, remaps);
  if (node.program() == "tws_launch/progress_node") {
    progress_ = std::make_unique<ProgressNode>(bus, log_);
    return;
  }
  const auto found = registry.find(node.program());
  if (found == registry.end())
    throw std::runtime_error("node /" + node.name + ": the offline runner does not know " + node.program());
  if (const auto* make = std::get_if<SourceMaker>(&found->second))
    sources_.push_back((*make)(bus));
  else
    nodes_.push_back(std::get<NodeMaker>(found->second)(bus));
}

std::vector<tws_runtime::Source*> OfflineGraph::sources() const {
  std::vector<tws_runtime::Source*> sources;
  std::transform(sources_.begin(), sources_.end(), std::back_inserter(sources), [](const auto& s) { return s.get(); });
  return sources;
}

ProgressNode& OfflineGraph::progress() {
  if (!progress_) throw std::runtime_error("the graph has no progress node");
  return *progress_;
}

}  // namespace tws_launch
