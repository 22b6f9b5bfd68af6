#pragma once

#include <cstdint>
#include <map>
#include <set>
#include <string>

namespace tws_runtime {

/// How many subscribers each topic has, as the nodes that publish it say (getBusInfo of ROS's slave API): what they
/// publish from now on reaches so many. Of several publishers the one that has fewest counts. All subscribers of this
/// process count, those of another process as one. 0 where nobody publishes, or a publisher does not answer in time.
/// Names are absolute. Takes at most about `timeout` [s of wall time], > 0; may be called from any thread.
using SubscriberCounts = std::map<std::string, std::uint32_t>;
SubscriberCounts subscriberCounts(const std::set<std::string>& topics, double timeout);

}  // namespace tws_runtime
