#include "data_clock.h"

#include <cmath>

namespace asterix_bridge {

double nearestTime(double time_of_day, double modulus, double near) {
  return time_of_day + modulus * std::round((near - time_of_day) / modulus);
}

void DataClock::receiveAt(double time) {
  now_ = time;
  is_set_ = is_received_ = true;
}

double DataClock::full(double time_of_day) {
  const double time = nearestTime(time_of_day, kDay, now_);
  move(time);
  return time;
}

double DataClock::fullFromTruncated(double time) {
  // It starts anew at midnight, and a day is no multiple of 512 s: so it is counted from each day's own beginning.
  double best = std::nan("");
  const double today = std::floor(now_ / kDay) * kDay;
  for (const double day : {today, today - kDay, today + kDay}) {
    const double full = day + nearestTime(time, 512.0, now_ - day);
    const bool is_of_day = full >= day && full < day + kDay;
    if (is_of_day && !(std::abs(full - now_) >= std::abs(best - now_))) best = full;
  }
  if (is_set_) move(best);
  return best;
}

void DataClock::move(double time) {
  constexpr double kMinute = 60.0;
  if (is_received_ || std::isnan(time)) return;
  const bool agrees = contradiction_ && std::abs(time - *contradiction_) < kMinute;
  if (!is_set_ || agrees || std::abs(time - now_) < kMinute) {
    now_ = time;
    is_set_ = true;
    contradiction_.reset();
  } else {
    contradiction_ = time;
  }
}

}  // namespace asterix_bridge
