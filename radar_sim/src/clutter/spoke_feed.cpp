#include "clutter/spoke_feed.h"

#include <algorithm>
#include <cmath>

namespace radar_sim {

SpokeFeed::SpokeFeed(const Antenna& antenna, double beamwidth, double start_time)
    : antenna_(antenna),
      start_time_(start_time),
      per_scan_(static_cast<std::int64_t>(spokes(beamwidth))),
      next_(static_cast<std::int64_t>(
          std::floor(antenna.angleAt(start_time) * static_cast<double>(per_scan_) / tws::kTwoPi))) {}

void SpokeFeed::add(std::shared_ptr<const ClutterSpec> spec, std::unique_ptr<Clutter> clutter) {
  clutter_.push_back({std::move(spec), std::move(clutter)});
}

Spoke SpokeFeed::spokeOf(std::int64_t running) const {
  const double width = tws::kTwoPi / static_cast<double>(per_scan_);
  const std::int64_t number = (running % per_scan_ + per_scan_) % per_scan_;
  return {running,
          number,
          static_cast<double>(number) * width,
          width,
          antenna_.timeAt(static_cast<double>(running) * width),
          width / antenna_.rate()};
}

void SpokeFeed::raise(double until, std::vector<Echo>& echoes) {
  if (isEmpty()) return;
  for (Spoke spoke = spokeOf(next_); spoke.time < until; spoke = spokeOf(++next_)) {
    for (const Entry& entry : clutter_) {
      const std::size_t before = echoes.size();
      if (entry.spec->existsAt(spoke.time)) entry.clutter->raise(spoke, echoes);
      const auto isTooEarly = [this](const Echo& echo) { return echo.time < start_time_; };
      const auto fresh = echoes.begin() + static_cast<std::ptrdiff_t>(before);
      echoes.erase(std::remove_if(fresh, echoes.end(), isTooEarly), echoes.end());
    }
  }
}

}  // namespace radar_sim
