#include "held_plots.h"

#include <algorithm>
#include <numeric>

namespace range_gate_tracker {

void HeldPlots::add(std::int64_t running, const std::vector<tws::Plot>& plots) {
  Sector sector{running, {}, std::vector<std::uint32_t>(plots.size())};
  for (const tws::Plot& plot : plots) sector.plots.push_back({plot, running, false});
  std::iota(sector.by_range.begin(), sector.by_range.end(), 0U);
  std::stable_sort(sector.by_range.begin(), sector.by_range.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return plots[a].range < plots[b].range; });
  sectors_.push_back(std::move(sector));
}

void HeldPlots::forgetBefore(std::int64_t running) {
  while (!sectors_.empty() && sectors_.front().running < running) sectors_.pop_front();
}

std::vector<HeldPlot*> HeldPlots::in(const TrackWindow& window) {
  constexpr double kRounding = 1.0;  // [m] contains() decides at the edge.
  std::vector<HeldPlot*> inside;
  for (Sector& sector : sectors_) {
    if (!window.isOpenIn(sector.running)) continue;
    const auto begin_of_sector = static_cast<std::ptrdiff_t>(inside.size());
    auto place =
        std::lower_bound(sector.by_range.begin(), sector.by_range.end(), window.range - window.half_range - kRounding,
                         [&](std::uint32_t i, double range) { return sector.plots[i].plot.range < range; });
    for (; place != sector.by_range.end(); ++place) {
      HeldPlot& held = sector.plots[*place];
      if (held.plot.range > window.range + window.half_range + kRounding) break;
      if (window.contains(held.plot)) inside.push_back(&held);
    }
    std::sort(inside.begin() + begin_of_sector, inside.end());
  }
  return inside;
}

}  // namespace range_gate_tracker
