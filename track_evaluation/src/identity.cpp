#include "identity.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace track_evaluation {
namespace {

std::size_t largest(const std::map<std::uint32_t, std::size_t>& counts) {
  std::size_t most = 0;
  for (const auto& [who, count] : counts) most = std::max(most, count);
  return most;
}

}  // namespace

void IdentityMetrics::addPlot(double time, std::uint32_t identity, const Eigen::Vector2d& position) {
  if (!std::isfinite(time) || !position.allFinite()) throw std::invalid_argument("a plot's time or place is no number");
  plots_.push_back({time, identity, position});
}

void IdentityMetrics::addUpdate(double time, std::uint32_t track, const Eigen::Vector2d& position) {
  if (!std::isfinite(time) || !position.allFinite())
    throw std::invalid_argument("an update's time or place is no number");
  updates_.push_back({time, track, position});
}

void IdentityMetrics::join(std::map<std::uint32_t, Count>& identities, std::map<std::uint32_t, Count>& tracks) const {
  std::vector<Event> plots = plots_, updates = updates_;
  const auto earlier = [](const Event& a, const Event& b) { return a.time < b.time; };
  std::stable_sort(plots.begin(), plots.end(), earlier);
  std::stable_sort(updates.begin(), updates.end(), earlier);
  for (const Event& plot : plots) ++identities[plot.who].plots;
  std::size_t first = 0;
  for (const Event& update : updates) {
    while (first < plots.size() && plots[first].time < update.time - params_.same_time) ++first;
    const Event* nearest = nullptr;
    double distance = params_.same_place;
    for (std::size_t i = first; i < plots.size() && plots[i].time <= update.time + params_.same_time; ++i) {
      const double its = (plots[i].position - update.position).norm();
      if (its >= distance) continue;
      distance = its;
      nearest = &plots[i];
    }
    if (nearest == nullptr) continue;
    Count& identity = identities[nearest->who];
    ++identity.updates;
    ++identity.by_other[update.who];
    identity.times.push_back(update.time);
    ++tracks[update.who].updates;
    ++tracks[update.who].by_other[nearest->who];
  }
}

MetricList IdentityMetrics::report() const {
  std::map<std::uint32_t, Count> identities, tracks;
  join(identities, tracks);
  double judged = 0, plots = 0, updates = 0, longest = 0, fragments = 0, gaps = 0, intervals = 0, worst = 0,
         monitor = 0;
  for (const auto& [identity, count] : identities) {
    if (params_.monitors.count(identity) > 0) monitor += static_cast<double>(count.updates);
    if (params_.monitors.count(identity) > 0 || count.plots < params_.least_plots) continue;
    judged += 1.0;
    plots += static_cast<double>(count.plots);
    updates += static_cast<double>(count.updates);
    longest += static_cast<double>(largest(count.by_other));
    fragments += static_cast<double>(count.by_other.size());
    for (std::size_t i = 1; i < count.times.size(); ++i) {
      const double gap = count.times[i] - count.times[i - 1];
      intervals += 1.0;
      gaps += gap > params_.long_gap ? 1.0 : 0.0;
      worst = std::max(worst, gap);
    }
  }
  double pure = 0.0, identified = 0.0;
  for (const auto& [track, count] : tracks) {
    pure += static_cast<double>(largest(count.by_other));
    identified += static_cast<double>(count.updates);
  }
  return {{"identities", judged},
          {"identified_plots", plots},
          {"update_probability", ratio(updates, plots)},
          {"purity", ratio(pure, identified)},
          {"continuity", ratio(longest, plots)},
          {"fragmentation", ratio(fragments, judged)},
          {"long_gap_share", ratio(gaps, intervals)},
          {"longest_gap_s", intervals > 0.0 ? worst : std::nan("")},
          {"monitor_updates", monitor}};
}

}  // namespace track_evaluation
