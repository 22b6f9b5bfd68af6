#include "identity.h"

#include <algorithm>
#include <cmath>
#include <limits>
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

/// Joins the updates before `until` with their plots, and takes out what is needed no more.
void IdentityMetrics::join(double until, std::vector<Event>& plots, std::vector<Event>& updates, Counts& counts) const {
  const auto earlier = [](const Event& a, const Event& b) { return a.time < b.time; };
  const auto before = [](const Event& event, double time) { return event.time < time; };
  std::stable_sort(plots.begin(), plots.end(), earlier);
  std::stable_sort(updates.begin(), updates.end(), earlier);
  const auto last = std::lower_bound(updates.begin(), updates.end(), until, before);
  std::size_t first = 0;
  for (auto update = updates.begin(); update != last; ++update) {
    while (first < plots.size() && plots[first].time < update->time - params_.same_time) ++first;
    const Event* nearest = nullptr;
    double distance = params_.same_place;
    for (std::size_t i = first; i < plots.size() && plots[i].time <= update->time + params_.same_time; ++i) {
      const double its = (plots[i].position - update->position).norm();
      if (its >= distance) continue;
      distance = its;
      nearest = &plots[i];
    }
    if (nearest != nullptr) pair(*nearest, *update, counts);
  }
  updates.erase(updates.begin(), last);
  const auto needed = std::lower_bound(plots.begin(), plots.end(), until - params_.same_time, before);
  for (auto plot = plots.begin(); plot != needed; ++plot) ++counts.identities[plot->who].plots;
  plots.erase(plots.begin(), needed);
}

void IdentityMetrics::pair(const Event& plot, const Event& update, Counts& counts) const {
  Count& identity = counts.identities[plot.who];
  if (identity.updates > 0) {
    const double gap = update.time - identity.last;
    identity.intervals += 1.0;
    identity.gaps += gap > params_.long_gap ? 1.0 : 0.0;
    identity.longest = std::max(identity.longest, gap);
  }
  identity.last = update.time;
  ++identity.updates;
  ++identity.by_other[update.who];
  ++counts.tracks[update.who].updates;
  ++counts.tracks[update.who].by_other[plot.who];
}

MetricList IdentityMetrics::report() const {
  Counts counts = counts_;
  std::vector<Event> plots_left = plots_, updates_left = updates_;
  join(std::numeric_limits<double>::infinity(), plots_left, updates_left, counts);
  double judged = 0, plots = 0, updates = 0, longest = 0, fragments = 0, gaps = 0, intervals = 0, worst = 0,
         monitor = 0;
  for (const auto& [identity, count] : counts.identities) {
    if (params_.monitors.count(identity) > 0) monitor += static_cast<double>(count.updates);
    if (params_.monitors.count(identity) > 0 || count.plots < params_.least_plots) continue;
    judged += 1.0;
    plots += static_cast<double>(count.plots);
    updates += static_cast<double>(count.updates);
    longest += static_cast<double>(largest(count.by_other));
    fragments += static_cast<double>(count.by_other.size());
    intervals += count.intervals;
    gaps += count.gaps;
    worst = std::max(worst, count.longest);
  }
  double pure = 0.0, identified = 0.0;
  for (const auto& [track, count] : counts.tracks) {
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
