#include "recorded_requests.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <stdexcept>

namespace tws_launch {

RecordedRequests::RecordedRequests(tws_runtime::LocalGraph& graph, const std::string& bag)
    : RecordedRequests(graph.addNode("recorded_requests"), bag) {}

RecordedRequests::RecordedRequests(tws_runtime::Bus& bus, const std::string& bag)
    : publisher_(bus.advertise<tws_msgs::OperatorRequest>("/adit/recorded_requests")) {
  try {
    rosbag::Bag file(bag, rosbag::bagmode::Read);
    for (const rosbag::MessageInstance& message : rosbag::View(file, rosbag::TopicQuery("/adit/operator_requests")))
      if (const auto request = message.instantiate<tws_msgs::OperatorRequest>())
        requests_.push_back(request);
      else
        bus.counter("requests left out").add("an operator's requests were recorded in the form of another version");
    if (!requests_.empty()) begin_ = rosbag::View(file).getBeginTime();
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(bag + ": is missing, truncated or no bag: " + error.what());
  }
}

void RecordedRequests::step() {
  for (const auto& request : requests_) publisher_.publish(request);
  begin_.reset();
}

}  // namespace tws_launch
