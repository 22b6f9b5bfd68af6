#include "recorded_requests.h"

#include <rosbag/view.h>
#include <tws_runtime/bag_file.h>

#include <algorithm>
#include <map>
#include <stdexcept>

#include "topic_name.h"

namespace tws_launch {
namespace {

// As the requests to the window tracker were called in version 0.1's first bags.
const std::map<std::string, std::string> kFormerTopics{{"window_tracker", "tws/operator_requests"}};

}  // namespace

bool repeatsRequests(const NodeDescription& node) {
  const std::string type = ros::message_traits::datatype<tws_msgs::OperatorRequest>();
  return std::any_of(node.says.begin(), node.says.end(), [&](const auto& said) { return said.second == type; });
}

std::optional<std::string> requestTopic(const RunInput& bag, const std::string& space, const std::string& tracker) {
  auto topic = bag.topics.find(resolvedName(space, tracker + "/operator_requests"));
  const auto former = kFormerTopics.find(tracker);
  if (topic == bag.topics.end() && former != kFormerTopics.end())
    topic = bag.topics.find(resolvedName(space, former->second));
  if (topic == bag.topics.end()) return std::nullopt;
  return topic->second;
}

RecordedRequests::RecordedRequests(tws_runtime::LocalGraph& graph, const RunInput& bag, const std::string& space,
                                   const std::string& tracker) {
  tws_runtime::Bus& bus = graph.addNode(resolvedName(space, "requests_to_" + tracker).substr(1));
  publisher_ = bus.advertise<tws_msgs::OperatorRequest>(resolvedName(space, tracker + "/recorded_requests"));
  if (const auto topic = requestTopic(bag, space, tracker)) read(bus, bag.path, *topic);
}

void RecordedRequests::read(tws_runtime::Bus& bus, const std::string& path, const std::string& topic) {
  rosbag::Bag file;
  tws_runtime::openBag(file, path);
  try {
    for (const rosbag::MessageInstance& message : rosbag::View(file, rosbag::TopicQuery(topic)))
      if (const auto request = tws_runtime::messageAs<tws_msgs::OperatorRequest>(message))
        requests_.push_back(request);
      else
        bus.counter("requests left out").add("an operator's requests were recorded in the form of another version");
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
  if (!requests_.empty()) begin_ = rosbag::View(file).getBeginTime();
}

void RecordedRequests::step() {
  for (const auto& request : requests_) publisher_.publish(request);
  begin_.reset();
}

}  // namespace tws_launch
