#include "beam_crossings.h"

#include <cmath>

#include <tws_core/angles.h>

namespace radar_sim {

BeamCrossings::BeamCrossings(const Antenna& antenna, const std::vector<Target>& targets, AzimuthOf azimuth,
                             double start_time)
    : antenna_(antenna), targets_(targets), azimuth_(std::move(azimuth)) {
  for (std::size_t i = 0; i < targets.size(); ++i) schedule(i, start_time);
}

std::optional<BeamCrossings::Crossing> BeamCrossings::next(double until) {
  while (!scheduled_.empty() && scheduled_.top().crossing.time < until) {
    const auto [crossing, found] = scheduled_.top();
    scheduled_.pop();
    // A quarter revolution on, lest the same crossing be found again.
    schedule(crossing.target, crossing.time + (found ? quarterRevolution() : 0.0));
    if (found) return crossing;
  }
  return std::nullopt;
}

double BeamCrossings::quarterRevolution() const { return tws::kTwoPi / antenna_.rate() / 4.0; }

void BeamCrossings::schedule(std::size_t target, double after) {
  const Trajectory& trajectory = *targets_[target].trajectory;
  for (double from = trajectory.nextExistence(after); std::isfinite(from);) {
    const auto crossing = antenna_.crossing(from, [&](double time) { return azimuth_(target, time); });
    if (!crossing) return scheduled_.push({{from + quarterRevolution(), target}, false});
    if (trajectory.existsAt(*crossing)) return scheduled_.push({{*crossing, target}, true});
    from = trajectory.nextExistence(*crossing);
  }
}

}  // namespace radar_sim
