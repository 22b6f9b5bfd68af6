#include <tws_core/tick_clock.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace tws {

int countFromSeconds(double seconds) {
  if (!(std::abs(seconds) <= 1e9)) {
    throw std::invalid_argument("countFromSeconds: " + std::to_string(seconds) +
                                " s is not a time within 1e9 s of zero");
  }
  // A millionth of a tick keeps a time that was a whole number of ticks from losing one to rounding.
  const auto ticks = static_cast<std::int64_t>(std::floor(seconds / kTimeLsb + 1e-6));
  return static_cast<int>(ticks & (kClockModulus - 1));
}

double TickClock::seconds(int count) {
  if (count < 0 || count >= kClockModulus) {
    throw std::invalid_argument("TickClock: count " + std::to_string(count) + " is not in 0..32767");
  }
  if (!ticks_) ticks_ = count;
  *ticks_ += moduloDifference(count, static_cast<int>(*ticks_ & (kClockModulus - 1)));
  return static_cast<double>(*ticks_) * kTimeLsb;
}

}  // namespace tws
