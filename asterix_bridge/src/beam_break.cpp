#include "beam_break.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include <tws_core/angles.h>
#include <tws_core/units.h>

namespace asterix_bridge {
namespace {

using Points = std::deque<tws::TimedAzimuth>;

constexpr std::size_t kMost = 400;  // the latest of them are enough
constexpr std::size_t kLeast = 3;   // that contradict
constexpr std::size_t kLeastForPhase = 6;
constexpr std::size_t kLeastForSpeed = 12;

bool agrees(const tws::TimedAzimuth& point, const tws::SteadyBeam& line, double tolerance) {
  return std::abs(tws::angularDifference(point.azimuth, line.azimuthAt(point.time))) < tolerance;
}

double shareThatAgrees(const Points& points, const tws::SteadyBeam& line, double tolerance) {
  const auto is_near = [&](const auto& point) { return agrees(point, line, tolerance); };
  return static_cast<double>(std::count_if(points.begin(), points.end(), is_near)) / static_cast<double>(points.size());
}

struct Span {
  double first, last;
};
Span spanOf(const Points& points) {
  const auto earlier = [](const auto& a, const auto& b) { return a.time < b.time; };
  const auto ends = std::minmax_element(points.begin(), points.end(), earlier);
  return {ends.first->time, ends.second->time};
}

// Σ exp(i(azimuth - rate·time)), times from `start`.
std::complex<double> resultant(const Points& points, double start, double rate) {
  std::complex<double> sum;
  for (const auto& point : points) sum += std::polar(1.0, point.azimuth - rate * (point.time - start));
  return sum;
}

// Least squares of what lies near the line.
tws::SteadyBeam refine(const Points& points, tws::SteadyBeam line, double tolerance) {
  double n = 0.0, t = 0.0, tt = 0.0, r = 0.0, tr = 0.0;
  for (const auto& point : points) {
    if (!agrees(point, line, tolerance)) continue;
    const double time = point.time - line.time;
    const double residual = tws::angularDifference(point.azimuth, line.azimuthAt(point.time));
    n += 1.0;
    t += time;
    tt += time * time;
    r += residual;
    tr += time * residual;
  }
  const double spread = n * tt - t * t;
  if (n < 3.0 || spread <= 0.0) return line;
  const double slope = (n * tr - t * r) / spread;
  line.azimuth += (r - slope * t) / n;
  line.rate += slope;
  return line;
}

tws::SteadyBeam lineAt(const Points& points, double start, double rate) {
  return {start, std::arg(resultant(points, start, rate)), rate};
}

// The most coherent rate from a third to three times the old one; of equals the one nearest to it.
double searchRate(const Points& points, const Span& span, double old) {
  constexpr int kPerWidth = 8;  // steps in the width of a maximum
  const double step = tws::kTwoPi / ((span.last - span.first) * kPerWidth);
  double best = old, greatest = 0.0;
  const auto consider = [&](double rate) {
    const double coherence = std::abs(resultant(points, span.first, rate));
    if (coherence <= greatest * 1.001) return;
    greatest = coherence;
    best = rate;
  };
  for (double away = 0.0; away < 2.0 * old; away += step) {
    consider(old + away);
    if (old - away > old / 3.0) consider(old - away);
  }
  return best;
}

}  // namespace

// What plots and marks are off their beam at most: their own error, and times in steps of 1/128 s [rad].
double BeamBreak::tolerance(double rate) const {
  constexpr double kMedians = 4.0;
  return std::clamp(kMedians * scatter_, tws::radians(8.0) + rate / 128.0, tws::radians(60.0));
}

void BeamBreak::add(const tws::TimedAzimuth& point, const tws::SteadyBeam& line) {
  const bool contradicts = !agrees(point, line, tolerance(line.rate));
  if (!contradicts && suspects_.empty()) return;
  suspects_.push_back(point);
  contradicting_ += contradicts ? 1 : 0;
  if (2 * contradicting_ <= suspects_.size()) return clear();
  if (suspects_.size() <= kMost) return;
  contradicting_ -= agrees(suspects_.front(), line, tolerance(line.rate)) ? 0 : 1;
  suspects_.pop_front();
}

std::optional<double> BeamBreak::since() const {
  if (contradicting_ < kLeast) return std::nullopt;
  return suspects_.front().time;
}

void BeamBreak::clear() {
  suspects_.clear();
  contradicting_ = 0;
  tried_ = 0;
}

// The same speed at another phase is likelier than another speed that fits as well.
std::optional<tws::SteadyBeam> BeamBreak::find(const tws::SteadyBeam& line, double nominal) {
  constexpr double kMostOf = 0.8;
  if (suspects_.size() < kLeastForPhase || suspects_.size() < tried_ + tried_ / 16 + 1) return std::nullopt;
  tried_ = suspects_.size();
  const Span span = spanOf(suspects_);
  const double near = tolerance(line.rate);
  const auto isBeam = [&](const tws::SteadyBeam& found) {
    return span.last - span.first > tws::kTwoPi / found.rate && shareThatAgrees(suspects_, found, near) >= kMostOf;
  };
  for (const double rate : {line.rate, nominal > 0.0 ? tws::kTwoPi / nominal : line.rate}) {
    const tws::SteadyBeam found = refine(suspects_, lineAt(suspects_, span.first, rate), near);
    if (isBeam(found)) return found;
  }
  if (suspects_.size() < kLeastForSpeed || span.last <= span.first) return std::nullopt;
  const tws::SteadyBeam rough = lineAt(suspects_, span.first, searchRate(suspects_, span, line.rate));
  const tws::SteadyBeam found = refine(suspects_, refine(suspects_, rough, near), near);
  if (isBeam(found)) return found;
  return std::nullopt;
}

}  // namespace asterix_bridge
