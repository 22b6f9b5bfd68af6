#pragma once

#include <tws_msgs/OperatorRequest.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/source.h>

#include <optional>
#include <string>
#include <vector>

#include "run_input.h"

namespace tws_launch {

/// Whether a node has operators whose requests it repeats in a replay (tws_runtime::RequestLog).
bool repeatsRequests(const NodeDescription& node);

/// The topic, as the bag has it, of what operators asked of a tracker in the namespace `space`; nothing: there is none.
std::optional<std::string> requestTopic(const RunInput& bag, const std::string& space, const std::string& tracker);

/// What operators asked of a tracker in a recorded run: all of it is handed over at the beginning, so that the tracker
/// can repeat each request where it took effect.
class RecordedRequests : public tws_runtime::Source {
 public:
  /// From TRACKER/operator_requests of the bag, in the namespace `space`, to TRACKER/recorded_requests. Throws
  /// std::runtime_error when the bag cannot be read.
  RecordedRequests(tws_runtime::LocalGraph& graph, const RunInput& bag, const std::string& space,
                   const std::string& tracker);

  std::optional<ros::Time> nextTime() const override { return begin_; }
  void step() override;

 private:
  void read(tws_runtime::Bus& bus, const std::string& path, const std::string& topic);

  tws_runtime::Publisher<tws_msgs::OperatorRequest> publisher_;
  std::vector<tws_msgs::OperatorRequest::ConstPtr> requests_;
  std::optional<ros::Time> begin_;  // of the bag; nothing: there are no more
};

}  // namespace tws_launch
