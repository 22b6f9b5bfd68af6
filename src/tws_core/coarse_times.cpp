#include <tws_core/coarse_times.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>

#include <tws_core/angles.h>
#include <tws_core/instant.h>

namespace tws {
namespace {

constexpr std::size_t kFewPlots = 20;

std::vector<double> distinctTimes(const TimedAzimuths& plots) {
  std::vector<double> times;
  times.reserve(plots.size());
  for (const TimedAzimuth& plot : plots) times.push_back(plot.time);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// How far the beam stands from the plots' azimuths at their times, in the middle of all [rad]. Plots all round
// show none: then the times count as cut off.
double middleOf(const TimedAzimuths& plots, const Rotation& rotation, double step) {
  constexpr double kClearly = 0.4;
  std::complex<double> sum;
  for (const TimedAzimuth& plot : plots) sum += std::polar(1.0, plot.azimuth - rotation.unwrappedAt(plot.time));
  if (std::abs(sum) < kClearly * static_cast<double>(plots.size())) return kPi * step / rotation.period();
  return std::arg(sum);
}

// How much the mean directions of plots of one time differ from those of the next time, 0 .. 2: little when each time
// stands for a whole revolution.
double changeOfDirections(const TimedAzimuths& plots) {
  double sum = 0.0, changes = 0.0;
  std::optional<std::complex<double>> before;
  for (auto first = plots.begin(); first != plots.end();) {
    const auto last = endOfInstant(first, plots.end());
    std::complex<double> mean;
    for (auto plot = first; plot != last; ++plot) mean += std::polar(1.0, plot->azimuth);
    mean /= static_cast<double>(last - first);
    if (before) changes += 1.0;
    if (before) sum += std::abs(mean - *before);
    before = mean;
    first = last;
  }
  return sum / std::max(1.0, changes);
}

}  // namespace

double commonStep(const TimedAzimuths& plots) {
  constexpr double kLeast = 0.02, kNear = 0.001;  // [s]
  const std::vector<double> times = distinctTimes(plots);
  if (plots.size() < kFewPlots || times.size() < 3) return 0.0;
  double step = times.back() - times.front();
  for (std::size_t i = 1; i < times.size(); ++i) step = std::min(step, times[i] - times[i - 1]);
  if (step < kLeast) return 0.0;
  step = (times.back() - times.front()) / std::round((times.back() - times.front()) / step);
  const double near = std::min(kNear, step / 50.0);
  const bool even = std::all_of(times.begin(), times.end(), [&](double time) {
    return std::abs(std::remainder(time - times.front(), step)) < near;
  });
  return even ? step : 0.0;
}

std::vector<double> refinedTimes(const TimedAzimuths& plots, const Rotation& rotation, double step) {
  const double middle = middleOf(plots, rotation, step);
  std::vector<double> times;
  times.reserve(plots.size());
  for (const TimedAzimuth& plot : plots) {
    const double beam = rotation.unwrappedAt(plot.time) + middle;
    const double usual = rotation.timeAt(beam);
    const double time = rotation.timeAt(beam + angularDifference(plot.azimuth, beam));
    times.push_back(std::abs(time - usual) < step ? time : usual);
  }
  return times;
}

std::optional<Rotation> rotationOfWholeScans(const TimedAzimuths& plots) {
  constexpr double kShortest = 1.05, kLongest = 59.0;  // [s]
  constexpr double kSeveral = 3.0;                     // plots of one time
  // Ten plots of a whole scan change by 1.25 / √10 = 0.40 by chance, those of two thirds of one by 0.72 and more.
  constexpr double kLittle = 0.55;
  const double step = commonStep(plots);
  const auto scans = static_cast<double>(distinctTimes(plots).size());
  if (step < kShortest || step > kLongest || static_cast<double>(plots.size()) < kSeveral * scans) return std::nullopt;
  if (changeOfDirections(plots) > kLittle) return std::nullopt;
  return Rotation::uniform(step, -kTwoPi * std::remainder(plots.front().time, step) / step);
}

}  // namespace tws
