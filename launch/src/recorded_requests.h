#pragma once

#include <tws_msgs/OperatorRequest.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/source.h>

#include <string>
#include <vector>

namespace tws_launch {

/// What operators asked of the trackers in a recorded run (tws_runtime::RequestLog): all of it is handed over at the
/// beginning, so that each tracker can repeat its requests where they took effect.
class RecordedRequests : public tws_runtime::Source {
 public:
  /// Throws std::runtime_error when the bag cannot be read.
  RecordedRequests(tws_runtime::LocalGraph& graph, const std::string& bag);

  std::optional<ros::Time> nextTime() const override { return begin_; }
  void step() override;

 private:
  RecordedRequests(tws_runtime::Bus& bus, const std::string& bag);

  struct Recorded {
    tws_runtime::Publisher<tws_msgs::OperatorRequest> to;
    std::vector<tws_msgs::OperatorRequest::ConstPtr> requests;
  };
  std::vector<Recorded> trackers_;
  std::optional<ros::Time> begin_;  // of the bag; nothing: there are no more
};

}  // namespace tws_launch
