#include "feed_time.h"

#include <algorithm>
#include <functional>

namespace asterix_bridge {

void FeedTime::Leads::add(double lead) {
  if (count < kConfirmed)
    greatest[count++] = lead;
  else if (lead > greatest.back())
    greatest.back() = lead;
  std::sort(greatest.begin(), greatest.begin() + static_cast<std::ptrdiff_t>(count), std::greater<>());
}

double FeedTime::Leads::confirmed() const {
  return count == 0 ? -std::numeric_limits<double>::infinity() : greatest[count - 1];
}

void FeedTime::add(double data, double wall) {
  constexpr double kMinute = 60.0, kNewRun = 10.0;
  const double lead = data - wall;
  behind_ = lead < leads_.confirmed() - kNewRun ? behind_ + 1 : 0;
  const bool is_new_run = behind_ >= kConfirmed;
  if (is_new_run || wall - since_ > kMinute) {
    last_leads_ = is_new_run ? Leads{} : leads_;
    leads_ = {};
    last_delays_ = is_new_run ? Leads{} : delays_;
    delays_ = {};
    since_ = wall;
    behind_ = 0;
  }
  leads_.add(lead);
  const double delay = at(wall) - data;
  if (delay < kMinute) delays_.add(std::max(delay, 0.0));
}

double FeedTime::at(double wall) const { return wall + std::max(leads_.confirmed(), last_leads_.confirmed()); }

double FeedTime::delay() const { return std::max({delays_.confirmed(), last_delays_.confirmed(), 0.0}); }

}  // namespace asterix_bridge
