#include "recorded_requests.h"

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include <stdexcept>
#include <utility>

namespace tws_launch {
namespace {

/// The trackers' nodes, and where their requests were recorded; windows' were on another topic before.
const std::vector<std::pair<std::string, std::vector<std::string>>> kTrackers = {
    {"adit", {"/adit/operator_requests"}},
    {"window_tracker", {"/window_tracker/operator_requests", "/tws/operator_requests"}}};

}  // namespace

RecordedRequests::RecordedRequests(tws_runtime::LocalGraph& graph, const std::string& bag)
    : RecordedRequests(graph.addNode("recorded_requests"), bag) {}

RecordedRequests::RecordedRequests(tws_runtime::Bus& bus, const std::string& bag) {
  try {
    rosbag::Bag file(bag, rosbag::bagmode::Read);
    for (const auto& [tracker, topics] : kTrackers) {
      Recorded& own = trackers_.emplace_back();
      own.to = bus.advertise<tws_msgs::OperatorRequest>("/" + tracker + "/recorded_requests");
      for (const rosbag::MessageInstance& message : rosbag::View(file, rosbag::TopicQuery(topics)))
        if (const auto request = message.instantiate<tws_msgs::OperatorRequest>())
          own.requests.push_back(request);
        else
          bus.counter("requests left out").add("an operator's requests were recorded in the form of another version");
      if (!own.requests.empty()) begin_ = rosbag::View(file).getBeginTime();
    }
  } catch (const rosbag::BagException& error) {
    throw std::runtime_error(bag + ": is missing, truncated or no bag: " + error.what());
  }
}

void RecordedRequests::step() {
  for (Recorded& tracker : trackers_)
    for (const auto& request : tracker.requests) tracker.to.publish(request);
  begin_.reset();
}

}  // namespace tws_launch
