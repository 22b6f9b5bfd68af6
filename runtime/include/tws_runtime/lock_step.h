#pragma once

#include <ros/time.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace tws_runtime {

/// The simulator's side of a closed loop. It sends reports, and what tracks them answers each with one command that
/// bears the report's stamp. A command takes effect at its stamp plus a fixed latency in data time: the step at time T
/// goes by the answers to all reports up to T - latency, so that live and offline agree. Live, the runtime waits for
/// these answers before the step (Source::isReady()). Once it has waited in vain (Source::stopWaiting()), nothing is
/// waited for until an answer comes again: a radar whose tracker has ended continues at full speed.
///
/// Times may differ by a microsecond without being late: grids of times are rounded to nanoseconds.
template <class Command>
class LockStep {
 public:
  /// Greater than 0 for a radar whose step at T takes what is due at T and then reports with the stamp T.
  explicit LockStep(ros::Duration latency) : latency_(latency) {}

  /// A report went out. Their stamps ascend.
  void sent(ros::Time stamp) {
    if (waits_) unanswered_.insert(stamp);
  }

  /// A command came. False: it is late (its effect would lie before a step already made) and takes effect at the next
  /// one, or it is not newer than one that has taken effect, and is ignored.
  bool add(ros::Time stamp, Command command) {
    waits_ = true;
    unanswered_.erase(unanswered_.begin(), unanswered_.upper_bound(stamp));
    if (newest_effect_ && stamp <= *newest_effect_) return false;
    pending_.insert_or_assign(stamp, std::move(command));
    return !newest_step_ || !isDue(stamp, *newest_step_);
  }

  /// Whether all commands have come by which the step at `time` goes.
  bool isReady(ros::Time time) const { return unanswered_.empty() || !isDue(*unanswered_.begin(), time); }

  /// The wait was in vain.
  void stopWaiting() {
    waits_ = false;
    unanswered_.clear();
  }

  /// The commands that take effect at the step at `time` and have not before, in order of their stamps. Steps never go
  /// back.
  std::vector<Command> takeDue(ros::Time time) {
    newest_step_ = time;
    std::vector<Command> due;
    while (!pending_.empty() && isDue(pending_.begin()->first, time)) {
      newest_effect_ = pending_.begin()->first;
      due.push_back(std::move(pending_.begin()->second));
      pending_.erase(pending_.begin());
    }
    return due;
  }

 private:
  /// Without sums of ros::Time, which throw for a bad stamp.
  bool isDue(ros::Time stamp, ros::Time step) const {
    constexpr std::int64_t kRounding = 1000;  // [ns]
    return static_cast<std::int64_t>(stamp.toNSec()) + latency_.toNSec() <=
           static_cast<std::int64_t>(step.toNSec()) + kRounding;
  }

  ros::Duration latency_;
  bool waits_ = true;
  std::set<ros::Time> unanswered_;
  std::map<ros::Time, Command> pending_;
  std::optional<ros::Time> newest_step_;
  std::optional<ros::Time> newest_effect_;
};

}  // namespace tws_runtime
