#pragma once

#include <tws_msgs/OperatorRequest.h>

#include <cstdint>
#include <deque>
#include <functional>

namespace range_gate_tracker {

/// The operator's requests, each of which takes effect after a certain sector, so that a replay repeats it there.
class RequestQueue {
 public:
  /// False: that sector (or a later one) was processed already; the request takes effect with the next one.
  bool add(const tws_msgs::OperatorRequest& request, std::int64_t processed) {
    waiting_.push_back(request);
    return static_cast<std::int64_t>(request.running_sector) >= processed;
  }

  /// Hands over what takes effect after this sector, in the order in which it was asked.
  void release(std::int64_t running, const std::function<void(const tws_msgs::OperatorRequest&)>& take) {
    std::deque<tws_msgs::OperatorRequest> later;
    for (const tws_msgs::OperatorRequest& request : waiting_) {
      if (static_cast<std::int64_t>(request.running_sector) > running)
        later.push_back(request);
      else
        take(request);
    }
    waiting_.swap(later);
  }

  void clear() { waiting_.clear(); }

 private:
  std::deque<tws_msgs::OperatorRequest> waiting_;
};

}  // namespace range_gate_tracker
