#include <tws_core/clock_steps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include <tws_core/angles.h>
#include <tws_core/rotation_search.h>
#include <tws_core/units.h>

namespace tws {
namespace {

constexpr double kTurnsAround = 2.5;  // of a break that are looked at
constexpr double kOff = radians(20.0);

double misfitOf(const TimedAzimuth& plot, const SteadyBeam& beam) {
  return std::min(std::abs(angularDifference(plot.azimuth, beam.azimuthAt(plot.time))), kOff);
}

/// Which plots around a break lie on the beam as it was before, and which on the later one: first only the former, then
/// both between each other, then only the latter. Each of the three may be missing.
class Parting {
 public:
  Parting(const TimedAzimuths& plots, const Rotation::Break& at) : plots_(plots), break_(at) {
    const double around = kTurnsAround * kTwoPi / at.before.rate;
    const TimedAzimuth* const last = plots.data() + plots.size();
    first_ = static_cast<std::size_t>(firstNotBefore(plots.data(), last, at.time - around) - plots.data());
    last_ = static_cast<std::size_t>(firstNotBefore(plots.data(), last, at.time + around) - plots.data());
    part();
  }

  bool isAfter(std::size_t plot) const {
    if (plot < first_ || plot >= last_) return plot >= last_;
    const Stage stage = stages_[plot - first_];
    return stage == kAfter || (stage == kBoth && before(plot) > after(plot));
  }
  /// The last plot's time on the earlier beam and the first one's on the later [s]; nothing: one has none.
  struct Ends {
    double last_before, first_after;
  };
  std::optional<Ends> ends() const {
    Ends ends{-kNever, kNever};
    for (std::size_t i = first_; i < last_; ++i) {
      const bool is_after = isAfter(i);
      if ((is_after ? after(i) : before(i)) >= kOff / 2.0) continue;
      is_after ? ends.first_after = std::min(ends.first_after, plots_[i].time) : ends.last_before = plots_[i].time;
    }
    if (ends.last_before == -kNever || ends.first_after == kNever) return std::nullopt;
    return ends;
  }

 private:
  static constexpr double kNever = std::numeric_limits<double>::infinity();
  enum Stage { kBefore, kBoth, kAfter };

  double before(std::size_t plot) const { return misfitOf(plots_[plot], break_.before); }
  double after(std::size_t plot) const { return misfitOf(plots_[plot], break_.after); }

  // The cheapest way through the stages. One plot in both is dearer than on one beam, so that chance makes no overlap;
  // so little that one stray plot, which costs kOff, is worth an overlap of 20 plots: of seconds, as clocks are set by.
  void part() {
    constexpr double kDearer = radians(1.0);
    std::array<double, 3> costs{0.0, 0.0, 0.0};
    std::vector<std::array<Stage, 3>> from;
    for (std::size_t i = first_; i < last_; ++i) {
      const std::array<double, 3> own{before(i), std::min(before(i), after(i)) + kDearer, after(i)};
      const Stage to_both = costs[kBefore] <= costs[kBoth] ? kBefore : kBoth;
      const Stage to_after = costs[to_both] <= costs[kAfter] ? to_both : kAfter;
      from.push_back({kBefore, to_both, to_after});
      costs = {costs[kBefore] + own[kBefore], costs[to_both] + own[kBoth], costs[to_after] + own[kAfter]};
    }
    auto stage = static_cast<Stage>(std::min_element(costs.begin(), costs.end()) - costs.begin());
    stages_.resize(from.size());
    for (std::size_t i = from.size(); i-- > 0;) {
      stages_[i] = stage;
      stage = from[i][stage];
    }
  }

  const TimedAzimuths& plots_;
  const Rotation::Break& break_;
  std::size_t first_ = 0, last_ = 0;
  std::vector<Stage> stages_;
};

// By what the clock was put forward: the beams say it but for whole revolutions; of those, as many as leave the least
// time without plots.
std::optional<ClockStep> stepAt(const Rotation::Break& at, const Parting& parting) {
  constexpr double kSameSpeed = 0.02, kNear = 0.02;
  const double period = kTwoPi / at.before.rate;
  if (std::abs(at.after.rate / at.before.rate - 1.0) > kSameSpeed) return std::nullopt;
  const auto ends = parting.ends();
  if (!ends) return std::nullopt;
  const double pause = ends->first_after - ends->last_before;
  if (std::abs(pause) > kTurnsAround * period) return std::nullopt;
  const double middle = (ends->first_after + ends->last_before) / 2.0;
  const double ahead = (at.before.azimuthAt(middle) - at.after.azimuthAt(middle)) / at.before.rate;
  const double turns = std::floor((pause + kNear * period - ahead) / period);
  return ClockStep{ends->last_before, ahead + turns * period};
}

// The part with the most plots keeps its times.
void keepLongest(std::vector<double>& corrections) {
  std::vector<double> sorted = corrections;
  std::sort(sorted.begin(), sorted.end());
  double kept = 0.0;
  std::ptrdiff_t most = 0;
  for (auto first = sorted.begin(); first != sorted.end();) {
    const auto next = std::upper_bound(first, sorted.end(), *first);
    if (next - first > most) kept = *first;
    most = std::max(most, next - first);
    first = next;
  }
  for (double& correction : corrections) correction -= kept;
}

}  // namespace

ClockSteps findClockSteps(const TimedAzimuths& plots, const Rotation& rotation) {
  ClockSteps found;
  found.corrections.assign(plots.size(), 0.0);
  for (const Rotation::Break& at : rotation.breaks()) {
    const Parting parting(plots, at);
    const auto step = stepAt(at, parting);
    if (!step) continue;
    found.steps.push_back(*step);
    for (std::size_t i = 0; i < plots.size(); ++i)
      if (parting.isAfter(i)) found.corrections[i] -= step->step;
  }
  keepLongest(found.corrections);
  return found;
}

}  // namespace tws
