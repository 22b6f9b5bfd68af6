#include "subscriber_wait.h"

#include <ros/console.h>
#include <ros/time.h>
#include <tws_runtime/ros_bus.h>
#include <tws_runtime/run.h>

#include <cstdint>
#include <map>
#include <set>
#include <string>

#include "subscriber_counts.h"

namespace tws_runtime {
namespace {

constexpr double kPeriod = 0.05;        // [s of wall time] between two looks
constexpr double kLongestAnswer = 1.0;  // [s of wall time]: a node that takes longer is asked again

struct Subscribers {
  std::uint32_t wanted = 0, found = 0;
};
using Missing = std::map<std::string, Subscribers>;

/// Looks again at the topics that have too few.
void lookAgain(Missing& missing) {
  std::set<std::string> topics;
  for (const auto& [topic, subscribers] : missing) topics.insert(topic);
  for (const auto& [topic, found] : subscriberCounts(topics, kLongestAnswer)) {
    const auto entry = missing.find(topic);
    entry->second.found = found;
    if (found >= entry->second.wanted) missing.erase(entry);
  }
}

std::string textOf(const Missing& missing) {
  std::string text;
  for (const auto& [topic, subscribers] : missing)
    text += (text.empty() ? "" : ", ") + topic + " (" + std::to_string(subscribers.found) + " of " +
            std::to_string(subscribers.wanted) + ")";
  return text;
}

}  // namespace

void waitForSubscribers(RosBus& bus, const LiveOptions& options) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(options.wait_timeout);
  Missing missing;
  for (const std::string& topic : options.wait_for) ++missing[bus.resolved(topic)].wanted;
  while (bus.ok() && !missing.empty()) {
    lookAgain(missing);
    if (missing.empty()) return;
    if (ros::WallTime::now() >= end) break;
    bus.spinFor(kPeriod);
  }
  if (bus.ok() && !missing.empty())
    ROS_WARN_STREAM(bus.name() << ": too few subscribers after " << options.wait_timeout << " s: " << textOf(missing)
                               << "; starting without them");
}

}  // namespace tws_runtime
