#pragma once

#include <tws_runtime/local_graph.h>
#include <tws_runtime/source.h>

#include <iosfwd>
#include <memory>
#include <vector>

#include "graph_description.h"
#include "progress_node.h"

namespace tws_launch {

/// The nodes of a launch file in one process, without a master. This is the one place that knows every node.
class OfflineGraph {
 public:
  /// Makes the nodes in the order of the launch file; those that only a live graph has (recorder, player, display) are
  /// left out. Log lines and progress go to `log`. Throws std::runtime_error for a node that is not known here, and
  /// what a node throws.
  OfflineGraph(const std::vector<NodeDescription>& nodes, std::ostream& log);

  tws_runtime::LocalGraph& graph() { return graph_; }
  /// The simulators and recordings among the nodes.
  std::vector<tws_runtime::Source*> sources() const;
  /// The launch file's progress node. Throws std::runtime_error when it has none.
  ProgressNode& progress();

 private:
  void add(const NodeDescription& node);

  std::ostream& log_;
  tws_runtime::LocalGraph graph_;
  std::vector<std::shared_ptr<void>> nodes_;
  std::vector<std::unique_ptr<tws_runtime::Source>> sources_;
  std::unique_ptr<ProgressNode> progress_;
};

}  // namespace tws_launch
