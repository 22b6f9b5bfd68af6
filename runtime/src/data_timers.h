#pragma once

#include <ros/time.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace tws_runtime {

/// Timers on data time. A deadline is a multiple of the period; its handler is called once data time has gone past it.
class DataTimers {
 public:
  using Handler = std::function<void(ros::Time deadline)>;

  /// Throws std::invalid_argument unless period_s is at least a nanosecond.
  void add(double period_s, Handler handler);

  struct Due {
    ros::Time deadline;
    Handler handler;
  };
  /// Takes the earliest deadline before `time`; nothing when there is none. Of equal deadlines the timer added first
  /// goes first. The first call sets the start: no deadline lies before it. When time goes back, it starts anew there;
  /// when it goes ahead by more than a minute, each timer's latest deadline stands for all that lie in between.
  std::optional<Due> takeBefore(ros::Time time);

  bool empty() const { return timers_.empty(); }

 private:
  struct Timer {
    std::int64_t period_ns;
    Handler handler;
    std::int64_t next_ns;
  };
  void startAt(std::int64_t time_ns);
  void skipTo(std::int64_t time_ns);

  std::vector<Timer> timers_;
  std::optional<std::int64_t> last_ns_;  ///< The latest time seen; nothing before the start.
};

}  // namespace tws_runtime
