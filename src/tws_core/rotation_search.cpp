#include <tws_core/rotation_search.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <sstream>
#include <stdexcept>

#include <tws_core/angles.h>

namespace tws {
namespace {

using TimedPlots = TimedAzimuths;
using Windows = std::vector<PlotWindow>;

constexpr double kShortestPeriod = 0.19;  // [s] a little beyond 0.2..120 s, so that both ends are found
constexpr double kLongestPeriod = 127.0;
constexpr double kLeastTurns = 3.0;  // fewer do not tell a rotation from plots that happen to lie close together
constexpr std::size_t kLeastPlots = 20;
constexpr std::size_t kLeastPlotsOfKnownPeriod = 5;
constexpr double kLeastCoherence = 0.5;

[[noreturn]] void refuse(const std::ostringstream& reason) { throw std::invalid_argument("Rotation: " + reason.str()); }

double durationOf(const TimedPlots& plots) { return plots.back().time - plots.front().time; }

double pairsOf(const Windows& windows) {
  double pairs = 0.0;
  for (const PlotWindow& window : windows) {
    const auto count = static_cast<double>(window.count());
    pairs += count * (count - 1.0);
  }
  return pairs;
}

// From the mean of cos(phase difference) over all pairs of plots of the same window: |Σ exp(i(az - 2πft))|² without its
// bias, so that windows of few and of many plots compare. Windows need not agree in phase, so slow drift does no harm.
double coherenceOf(const Windows& windows, double frequency) {
  double sum = 0.0;
  for (const PlotWindow& window : windows) {
    sum += std::norm(window.resultant(frequency)) - static_cast<double>(window.count());
  }
  return std::sqrt(std::max(0.0, sum / std::max(1.0, pairsOf(windows))));
}

// Golden-section search of a single maximum.
CoherencePeak refine(const Windows& windows, double low, double high) {
  constexpr double kGolden = 0.6180339887498949;
  constexpr int kSteps = 12;  // to 1/300 of the bracket
  for (int i = 0; i < kSteps; ++i) {
    const double left = high - kGolden * (high - low);
    const double right = low + kGolden * (high - low);
    if (coherenceOf(windows, left) > coherenceOf(windows, right)) {
      high = right;
    } else {
      low = left;
    }
  }
  const double frequency = (low + high) / 2.0;
  return {frequency, coherenceOf(windows, frequency)};
}

// Up to six windows, spread over the plots.
Windows windowsOf(const TimedPlots& plots, double duration) {
  const TimedAzimuth* const first = plots.data();
  const TimedAzimuth* const last = first + plots.size();
  const double latest_start = plots.back().time - duration;
  const auto starts = static_cast<std::size_t>(firstNotBefore(first, last, latest_start) - first);
  const auto wanted = static_cast<std::size_t>(std::clamp(durationOf(plots) / duration, 1.0, 6.0));
  Windows windows;
  for (std::size_t i = 0; i < wanted; ++i) {
    const TimedAzimuth* const start = first + (wanted == 1 ? 0 : starts * i / (wanted - 1));
    windows.emplace_back(start, firstNotBefore(start, last, start->time + duration * 1.000001));
  }
  return windows;
}

// Windows short enough that drift does no harm and long enough for 60 plots, so that chance finds no coherence.
double windowDuration(const TimedPlots& plots, double longest_period) {
  const double span = durationOf(plots);
  const double sparse = 60.0 * seenSpan(plots, longest_period) / static_cast<double>(plots.size());
  return std::min(span, std::clamp(sparse, 8.0 * longest_period, 200.0 * longest_period));
}

// The best of a grid of frequencies so close that it is on the slope of the greatest maximum.
CoherencePeak bestNear(const Windows& windows, double frequency, double tolerance, double duration) {
  const auto steps = static_cast<int>(std::ceil(frequency * tolerance * 8.0 * duration));
  CoherencePeak best{frequency, 0.0};
  for (int i = -steps; i <= steps; ++i) {
    const double tried = frequency * (1.0 + tolerance * i / steps);
    const double coherence = coherenceOf(windows, tried);
    if (coherence > best.coherence) best = {tried, coherence};
  }
  return best;
}

// The local maxima of a band of frequencies; each is 1/duration wide on either side.
class Band {
 public:
  Band(const TimedPlots& plots, double low, double high)
      : duration_(windowDuration(plots, 1.0 / low)), windows_(windowsOf(plots, duration_)), pairs_(pairsOf(windows_)) {
    for (double frequency = low - step(); frequency < high + 2.0 * step(); frequency += step()) {
      grid_.push_back({frequency, coherenceOf(windows_, frequency)});
    }
  }

  std::vector<CoherencePeak> peaks() const {
    const double greatest = std::max_element(grid_.begin(), grid_.end(), less)->coherence;
    std::vector<CoherencePeak> peaks;
    for (std::size_t i = 1; i + 1 < grid_.size(); ++i) {
      if (!isMaximum(i) || grid_[i].coherence < 0.9 * greatest) continue;
      const CoherencePeak peak = refine(windows_, grid_[i - 1].frequency, grid_[i + 1].frequency);
      if (isSignificant(peak)) peaks.push_back(peak);
    }
    return peaks;
  }

  static bool less(const CoherencePeak& a, const CoherencePeak& b) { return a.coherence < b.coherence; }

 private:
  double step() const { return 1.0 / (8.0 * duration_); }
  bool isMaximum(std::size_t i) const {
    return grid_[i].coherence > grid_[i - 1].coherence && grid_[i].coherence >= grid_[i + 1].coherence;
  }
  // Without a beam, coherence² √pairs exceeds x in one window with probability exp(-x), in several more rarely.
  bool isSignificant(const CoherencePeak& peak) const {
    const double needed = 8.0 + std::log(static_cast<double>(grid_.size()));
    return peak.coherence * peak.coherence * std::sqrt(pairs_) > needed;
  }

  double duration_;
  Windows windows_;
  double pairs_;
  std::vector<CoherencePeak> grid_;
};

std::vector<CoherencePeak> peaksOfAllBands(const TimedPlots& plots) {
  std::vector<CoherencePeak> peaks;
  const double longest = std::min(kLongestPeriod, durationOf(plots) / kLeastTurns);
  for (double period = longest; period > kShortestPeriod; period /= 2.0) {
    const Band band(plots, 1.0 / period, 1.0 / std::max(kShortestPeriod, period / 2.0));
    const std::vector<CoherencePeak> found = band.peaks();
    peaks.insert(peaks.end(), found.begin(), found.end());
  }
  return peaks;
}

CoherencePeak greatestOf(const std::vector<CoherencePeak>& peaks) {
  return *std::max_element(peaks.begin(), peaks.end(), Band::less);
}

// Plots at even steps of time agree with several periods alike; the longest is the one that they show without leaps.
// Plots at few azimuths agree with fractions of the period as well, with false plots by chance even better, but not
// with its multiples: of the greatest peak and those it may be a fraction of, the one with the longest period.
double fundamentalOf(const std::vector<CoherencePeak>& peaks) {
  const CoherencePeak greatest = greatestOf(peaks);
  double frequency = greatest.frequency;
  for (const CoherencePeak& peak : peaks) {
    const double ratio = greatest.frequency / peak.frequency;
    // A peak among false plots may be 1 % off.
    const bool is_multiple = ratio > 1.5 && std::abs(ratio - std::round(ratio)) < 0.05 + 0.01 * ratio;
    const double needed = is_multiple ? 0.7 : 0.98;
    if (peak.coherence > needed * greatest.coherence) frequency = std::min(frequency, peak.frequency);
  }
  return frequency;
}

void checkNumber(const TimedPlots& plots, std::size_t least) {
  if (plots.size() >= least) return;
  std::ostringstream reason;
  reason << plots.size() << " plots are too few to find the rotation: it takes at least " << least;
  refuse(reason);
}

void checkCoherence(double coherence, const TimedPlots& plots, double shortest, double longest) {
  if (coherence >= kLeastCoherence) return;
  std::ostringstream reason;
  reason << plots.size() << " plots over " << durationOf(plots) << " s do not lie along a beam that turns clockwise in "
         << shortest;
  if (longest > shortest) reason << " to " << longest;
  reason << " s";
  refuse(reason);
}

}  // namespace

PlotWindow::PlotWindow(const TimedAzimuth* first, const TimedAzimuth* last)
    : first_(first), size_(static_cast<std::size_t>(last - first)), stride_(1) {
  constexpr std::size_t kEnough = 300;
  stride_ = size_ == 0 ? 1 : (size_ + kEnough - 1) / kEnough;
}

std::complex<double> PlotWindow::resultant(double frequency) const {
  double cosines = 0.0;
  double sines = 0.0;
  std::uint32_t random = 1;  // at even steps, plots of a few targets would show turns that are none
  for (std::size_t i = 0; i < size_;) {
    const double angle = first_[i].azimuth - kTwoPi * frequency * first_[i].time;
    cosines += std::cos(angle);
    sines += std::sin(angle);
    random = random * 1664525U + 1013904223U;
    i += stride_ == 1 ? 1 : 1 + (random >> 8) % (2 * stride_ - 1);
  }
  return {cosines, sines};
}

double seenSpan(const TimedAzimuths& plots, double period) {
  constexpr double kTurns = 100.0;
  double span = 0.0;
  for (std::size_t i = 1; i < plots.size(); ++i) {
    const double interval = plots[i].time - plots[i - 1].time;
    if (interval < kTurns * period) span += interval;
  }
  return span;
}

const TimedAzimuth* firstNotBefore(const TimedAzimuth* first, const TimedAzimuth* last, double time) {
  return std::lower_bound(first, last, time, [](const TimedAzimuth& plot, double t) { return plot.time < t; });
}

CoherencePeak peakNear(const TimedAzimuth* first, const TimedAzimuth* last, double frequency, double tolerance) {
  const Windows window{PlotWindow(first, last)};
  const double span = (last - 1)->time - first->time;
  if (span * frequency < kLeastTurns) return {frequency, coherenceOf(window, frequency)};
  return bestNear(window, frequency, tolerance, span);
}

double findFrequency(const TimedPlots& plots) {
  checkNumber(plots, kLeastPlots);
  if (durationOf(plots) < kLeastTurns * kShortestPeriod) {
    std::ostringstream reason;
    reason << "plots over " << durationOf(plots) << " s are too short to find the rotation: it takes three turns";
    refuse(reason);
  }
  const std::vector<CoherencePeak> peaks = peaksOfAllBands(plots);
  const double coherence = peaks.empty() ? 0.0 : greatestOf(peaks).coherence;
  checkCoherence(coherence, plots, 0.2, std::min(120.0, durationOf(plots) / kLeastTurns));
  return fundamentalOf(peaks);
}

double findFrequency(const TimedPlots& plots, double period) {
  checkNumber(plots, kLeastPlotsOfKnownPeriod);
  if (!(durationOf(plots) > 0.0)) throw std::invalid_argument("Rotation: all plots are of one instant");
  const double frequency = 1.0 / period;
  const double duration = windowDuration(plots, period);
  const Windows windows = windowsOf(plots, duration);
  CoherencePeak best{frequency, coherenceOf(windows, frequency)};
  if (durationOf(plots) >= kLeastTurns * period) best = bestNear(windows, frequency, 0.02, duration);
  checkCoherence(best.coherence, plots, period, period);
  return best.frequency;
}

}  // namespace tws
