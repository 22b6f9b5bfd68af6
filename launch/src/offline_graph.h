#pragma once

#include <tws_runtime/local_graph.h>
#include <tws_runtime/source.h>

#include <iosfwd>
#include <memory>
#include <vector>

#include "graph_description.h"
#include "node_registry.h"
#include "progress_node.h"

namespace tws_launch {

/// The nodes of a graph in one process, without a master.
class OfflineGraph {
 public:
  /// Makes the nodes in their order. Log lines and progress go to `log`. Throws std::runtime_error for a program that
  /// is not in the registry, and what a node throws.
  OfflineGraph(const GraphDescription& graph, std::ostream& log, const NodeRegistry& registry = nodeRegistry());

  tws_runtime::LocalGraph& graph() { return graph_; }
  /// The simulators and recordings among the nodes.
  std::vector<tws_runtime::Source*> sources() const;
  /// The graph's progress node. Throws std::runtime_error when it has none.
  ProgressNode& progress();

 private:
  void add(const NodeDescription& node, const GraphDescription& graph, const NodeRegistry& registry);

  std::ostream& log_;
  tws_runtime::LocalGraph graph_;
  std::vector<std::shared_ptr<void>> nodes_;
  std::vector<std::unique_ptr<tws_runtime::Source>> sources_;
  std::unique_ptr<ProgressNode> progress_;
};

}  // namespace tws_launch
