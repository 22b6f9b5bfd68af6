#include "data_timers.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tws_runtime {
namespace {

/// After a longer step of data time each timer is called once, not for all deadlines that lie in it.
constexpr std::int64_t kLongestGap = 60'000'000'000;  // [ns]

/// The smallest multiple of `period` that is not below `time`; both at least 0.
std::int64_t multipleFrom(std::int64_t time, std::int64_t period) { return (time + period - 1) / period * period; }

}  // namespace

void DataTimers::add(double period_s, Handler handler) {
  const double period_ns = std::round(period_s * 1e9);
  if (!(period_ns >= 1.0 && period_ns < 9e18))
    throw std::invalid_argument("timer period of " + std::to_string(period_s) + " s");
  const auto period = static_cast<std::int64_t>(period_ns);
  timers_.push_back({period, std::move(handler), multipleFrom(last_ns_.value_or(0), period)});
}

std::optional<DataTimers::Due> DataTimers::takeBefore(ros::Time time) {
  const auto time_ns = static_cast<std::int64_t>(time.toNSec());
  if (!last_ns_ || time_ns < *last_ns_) startAt(time_ns);
  if (time_ns - *last_ns_ > kLongestGap) skipTo(time_ns);
  last_ns_ = time_ns;
  const auto earlier = [](const Timer& a, const Timer& b) { return a.next_ns < b.next_ns; };
  const auto first = std::min_element(timers_.begin(), timers_.end(), earlier);
  if (first == timers_.end() || first->next_ns >= time_ns) return std::nullopt;
  Due due{ros::Time(), first->handler};
  due.deadline.fromNSec(static_cast<std::uint64_t>(first->next_ns));
  first->next_ns += first->period_ns;
  return due;
}

/// To the latest deadline before that time.
void DataTimers::skipTo(std::int64_t time_ns) {
  for (Timer& timer : timers_)
    timer.next_ns = std::max(timer.next_ns, multipleFrom(time_ns, timer.period_ns) - timer.period_ns);
}

void DataTimers::startAt(std::int64_t time_ns) {
  for (Timer& timer : timers_) timer.next_ns = multipleFrom(time_ns, timer.period_ns);
}

}  // namespace tws_runtime
