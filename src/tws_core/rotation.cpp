#include <tws_core/rotation.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <tws_core/angles.h>
#include <tws_core/beam_sense.h>
#include <tws_core/median.h>
#include <tws_core/rotation_search.h>
#include <tws_core/units.h>

namespace tws {
namespace {

constexpr double kGreatestDrift = 0.03;  // share by which the local turning rate may differ from the mean

// The mean beam of a few turns: wrapped azimuth [rad] at a time amid its plots [s], turning rate [rad/s].
struct BeamLine {
  double time;
  double azimuth;
  double rate;
  double scatter = 0.0;  // median of how far its plots are off [rad]
  double at(double t) const { return azimuth + rate * (t - time); }
};

void checkPeriod(double period) {
  if (period >= 0.01 && period <= 1e5) return;
  throw std::invalid_argument("Rotation: period " + std::to_string(period) + " s is not in 0.01..100000 s");
}

// In order of time, the earliest at time 0, so that phases stay exact for times far from zero. Returns that time.
double sortFromZero(TimedAzimuths& plots) {
  for (std::size_t i = 0; i < plots.size(); ++i) {
    if (std::abs(plots[i].time) <= 1e10 && std::isfinite(plots[i].azimuth)) continue;
    throw std::invalid_argument("Rotation: plot " + std::to_string(i) +
                                " has a time beyond 1e10 s or an azimuth that is not finite");
  }
  const auto earlier = [](const TimedAzimuth& a, const TimedAzimuth& b) {
    return std::pair(a.time, a.azimuth) < std::pair(b.time, b.azimuth);
  };
  if (!std::is_sorted(plots.begin(), plots.end(), earlier)) std::sort(plots.begin(), plots.end(), earlier);
  const double start = plots.empty() ? 0.0 : plots.front().time;
  for (TimedAzimuth& plot : plots) plot.time -= start;
  return start;
}

double medianResidual(const BeamLine& line, const TimedAzimuth* first, const TimedAzimuth* last) {
  std::vector<double> residuals;
  for (const TimedAzimuth* plot = first; plot != last; ++plot) {
    residuals.push_back(std::abs(wrapPi(plot->azimuth - line.at(plot->time))));
  }
  return median(std::move(residuals));
}

// Least squares of the residuals within the gate.
BeamLine refit(const BeamLine& line, const TimedAzimuth* first, const TimedAzimuth* last, double gate, bool keep_rate) {
  double n = 0.0, t = 0.0, tt = 0.0, r = 0.0, tr = 0.0;
  for (const TimedAzimuth* plot = first; plot != last; ++plot) {
    const double residual = wrapPi(plot->azimuth - line.at(plot->time));
    if (std::abs(residual) > gate) continue;
    const double time = plot->time - line.time;
    n += 1.0;
    t += time;
    tt += time * time;
    r += residual;
    tr += time * residual;
  }
  const double spread = tt - t * t / n;
  const double slope = keep_rate || spread <= 0.0 ? 0.0 : (tr - t * r / n) / spread;
  return {line.time + t / n, line.at(line.time + t / n) + r / n, line.rate + slope};
}

// Draws the line to what most plots agree on: at first from little more than the better half, then from all but those
// four standard deviations off by the median, which outliers do not move much.
BeamLine fitMost(BeamLine line, const TimedAzimuth* first, const TimedAzimuth* last, bool keep_rate) {
  constexpr double kDeviationsPerMedian = 1.4826;  // of a normal distribution
  constexpr double kLeastGate = radians(0.05);
  for (const double medians : {1.5, 1.5, 1.5, 1.5, 1.5, 1.5, 4.0 * kDeviationsPerMedian, 4.0 * kDeviationsPerMedian}) {
    line = refit(line, first, last, std::max(kLeastGate, medians * medianResidual(line, first, last)), keep_rate);
  }
  return line;
}

// How many plots lie near a beam that says where it points at a time.
template <class Beam>
std::ptrdiff_t countNear(const TimedAzimuth* first, const TimedAzimuth* last, const Beam& azimuthAt) {
  constexpr double kNear = kPi / 4.0;
  return std::count_if(first, last, [&](const TimedAzimuth& plot) {
    return std::abs(wrapPi(plot.azimuth - azimuthAt(plot.time))) < kNear;
  });
}

// A line through one half of plots that lie along two is none.
bool explains(const BeamLine& line, const TimedAzimuth* first, const TimedAzimuth* last) {
  constexpr double kMost = 0.65;
  const auto near = countNear(first, last, [&](double time) { return line.at(time); });
  return static_cast<double>(near) >= kMost * static_cast<double>(last - first);
}

// The beam through a window of plots; nothing when most of them do not lie along one.
std::optional<BeamLine> fitLine(const TimedAzimuth* first, const TimedAzimuth* last, double frequency) {
  constexpr double kLeastCoherence = 0.4;
  const CoherencePeak peak = peakNear(first, last, frequency, kGreatestDrift);
  if (peak.coherence < kLeastCoherence) return std::nullopt;
  const double azimuth = std::arg(PlotWindow(first, last).resultant(peak.frequency));
  const BeamLine coherent{0.0, azimuth, kTwoPi * peak.frequency};
  if (!explains(coherent, first, last)) return std::nullopt;
  const bool keep_rate = ((last - 1)->time - first->time) * frequency < 3.0;  // too short to tell it
  BeamLine line = fitMost(coherent, first, last, keep_rate);
  line.scatter = medianResidual(line, first, last);
  if (std::abs(line.rate / (kTwoPi * frequency) - 1.0) > 2.0 * kGreatestDrift) return std::nullopt;
  return line;
}

// The same where the antenna turns at another speed than elsewhere.
std::optional<BeamLine> fitLineAtAnySpeed(const TimedAzimuth* first, const TimedAzimuth* last, double frequency) {
  constexpr double kTimes = 3.0;
  if (const auto line = fitLine(first, last, frequency)) return line;
  try {
    const double other = findFrequency(TimedAzimuths(first, last));
    if (other > frequency / kTimes && other < frequency * kTimes) return fitLine(first, last, other);
  } catch (const std::invalid_argument&) {
  }
  return std::nullopt;
}

// Ten turns [s], more where plots are few.
double windowLength(const TimedAzimuths& plots, double frequency) {
  constexpr double kTurns = 10.0;
  constexpr double kPlots = 20.0;
  const double sparse = kPlots * seenSpan(plots, 1.0 / frequency) / static_cast<double>(plots.size());
  return std::clamp(sparse, kTurns / frequency, 20.0 * kTurns / frequency);
}

// Of two lines closer than a quarter of a window the later stays.
void append(std::vector<BeamLine>& lines, const BeamLine& line, double length) {
  if (!lines.empty() && line.time <= lines.back().time) return;
  if (!lines.empty() && line.time < lines.back().time + length / 4.0) lines.pop_back();
  lines.push_back(line);
}

// A break near an end is within the outer window, whose line, if any, is that of its better part: of the other part, a
// quarter or half of the window may have one.
std::optional<BeamLine> lineAtEnd(const TimedAzimuths& plots, const BeamLine& outer, double frequency, double length,
                                  bool late) {
  constexpr std::ptrdiff_t kLeastPlots = 12;
  const TimedAzimuth* const first = plots.data();
  const TimedAzimuth* const last = first + plots.size();
  for (const double part : {0.25, 0.5}) {
    const TimedAzimuth* const from = late ? firstNotBefore(first, last, plots.back().time - part * length) : first;
    const TimedAzimuth* const to = late ? last : firstNotBefore(first, last, part * length);
    if (to - from < kLeastPlots || explains(outer, from, to)) continue;
    const auto line = fitLine(from, to, frequency);
    if (line && (late ? line->time > outer.time : line->time < outer.time)) return line;
  }
  return std::nullopt;
}

void addEnds(std::vector<BeamLine>& lines, const TimedAzimuths& plots, double frequency, double length) {
  if (lines.empty()) return;
  if (const auto line = lineAtEnd(plots, lines.front(), frequency, length, false)) lines.insert(lines.begin(), *line);
  if (const auto line = lineAtEnd(plots, lines.back(), frequency, length, true)) lines.push_back(*line);
}

// Lines through windows of this length, each half over the one before, the last one whole as well.
std::vector<BeamLine> localLines(const TimedAzimuths& plots, double frequency, double length) {
  constexpr std::size_t kLeastPlots = 12;
  const TimedAzimuth* const end = plots.data() + plots.size();
  const double span = plots.back().time;
  std::vector<BeamLine> lines;
  for (const TimedAzimuth* first = plots.data(); first != end;) {
    if (first->time > span - length) first = firstNotBefore(plots.data(), end, span - length);
    const TimedAzimuth* const last = firstNotBefore(first, end, first->time + length * 1.000001);
    const bool long_enough = (last - 1)->time - first->time >= std::min(length / 2.0, span);
    if (long_enough && static_cast<std::size_t>(last - first) >= std::min(kLeastPlots, plots.size())) {
      const std::optional<BeamLine> line = fitLineAtAnySpeed(first, last, frequency);
      if (line) append(lines, *line, length);
    }
    first = last == end ? end : firstNotBefore(first, end, first->time + length / 2.0);
  }
  return lines;
}

// A line across a break lies far from its plots; without it the break is seen between its neighbours.
void dropWorst(std::vector<BeamLine>& lines) {
  constexpr double kTimes = 4.0, kLeast = radians(2.0);
  if (lines.size() < 3) return;
  std::vector<double> scatters;
  scatters.reserve(lines.size());
  for (const BeamLine& line : lines) scatters.push_back(line.scatter);
  const double most = std::max(kLeast, kTimes * median(std::move(scatters)));
  lines.erase(std::remove_if(lines.begin(), lines.end(), [&](const BeamLine& line) { return line.scatter > most; }),
              lines.end());
}

// How far plots are from the beam in all, outliers no more than others.
double misfit(double residual) { return std::min(std::abs(wrapPi(residual)), radians(20.0)); }

// Where the beam went over from one line to the next; nothing: it went evenly. `between`: the plots amid both.
std::optional<double> breakBetween(const BeamLine& before, const BeamLine& line, const TimedAzimuths& between) {
  constexpr double kClearly = radians(5.0), kLess = 0.5;
  if (between.size() < 4) return std::nullopt;
  const double turns = line.azimuth - before.azimuth;
  double even = 0.0, best = 0.0;
  for (const TimedAzimuth& plot : between) {
    const double share = (plot.time - before.time) / (line.time - before.time);
    even += misfit(plot.azimuth - before.azimuth - share * turns);
    best += misfit(plot.azimuth - line.at(plot.time));
  }
  std::size_t first_after = 0;
  double sum = best;
  for (std::size_t i = 0; i < between.size(); ++i) {
    const TimedAzimuth& plot = between[i];
    sum += misfit(plot.azimuth - before.at(plot.time)) - misfit(plot.azimuth - line.at(plot.time));
    if (sum < best) {
      best = sum;
      first_after = i + 1;
    }
  }
  if (even < kClearly * static_cast<double>(between.size()) || best > kLess * even) return std::nullopt;
  if (first_after == 0 || first_after == between.size()) return std::nullopt;
  return (between[first_after - 1].time + between[first_after].time) / 2.0;
}

TimedAzimuths plotsBetween(const TimedAzimuths& plots, double start, double end) {
  const TimedAzimuth* const last = plots.data() + plots.size();
  return TimedAzimuths(firstNotBefore(plots.data(), last, start), firstNotBefore(plots.data(), last, end));
}

// Counts the whole turns from line to line, by the mean of both rates; over a break, the fewest. The breaks' times
// stand for the line behind them, NaN: none.
std::vector<double> unwrap(std::vector<BeamLine>& lines, const TimedAzimuths& plots, double longest) {
  std::vector<double> breaks(lines.size(), std::nan(""));
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const BeamLine& before = lines[i - 1];
    BeamLine& line = lines[i];
    const double expected = before.azimuth + (line.time - before.time) * (before.rate + line.rate) / 2.0;
    line.azimuth = expected + wrapPi(line.azimuth - expected);
    if (line.time - before.time > longest) continue;
    const auto at = breakBetween(before, line, plotsBetween(plots, before.time, line.time));
    if (!at) continue;
    breaks[i] = *at;
    line.azimuth += kTwoPi * std::ceil((before.at(*at) + radians(0.1) - line.at(*at)) / kTwoPi);
  }
  return breaks;
}

}  // namespace

Rotation Rotation::uniform(double period, double azimuth_at_zero) {
  checkPeriod(period);
  if (!std::isfinite(azimuth_at_zero)) throw std::invalid_argument("Rotation: the azimuth at time 0 is not finite");
  return Rotation({{0.0, azimuth_at_zero}, {period, azimuth_at_zero + kTwoPi}});
}

Rotation Rotation::fromPlots(TimedAzimuths plots) {
  const double start = sortFromZero(plots);
  return follow(plots, findFrequency(plots), start);
}

Rotation Rotation::fromPlots(TimedAzimuths plots, double period) {
  checkPeriod(period);
  const double start = sortFromZero(plots);
  return follow(plots, findFrequency(plots, period), start);
}

// A beam far from most plots is none, however coherent some of them are.
static void checkThatItExplains(const Rotation& rotation, const TimedAzimuths& plots, double start) {
  constexpr double kMost = 0.6;
  const auto azimuthAt = [&](double time) { return rotation.unwrappedAt(start + time); };
  const auto near = countNear(plots.data(), plots.data() + plots.size(), azimuthAt);
  if (scansToAndFro(plots)) throw std::invalid_argument("Rotation: the antenna scans to and fro");
  if (static_cast<double>(near) >= kMost * static_cast<double>(plots.size())) return;
  throw std::invalid_argument("Rotation: the best beam, one turn in " + std::to_string(rotation.period()) +
                              " s, is near " + std::to_string(near) + " of " + std::to_string(plots.size()) +
                              " plots only");
}

// The knots are the lines' middles, where they are known best. The outer lines, and those beside a gap, go on by half a
// window: what lies between them is not known.
Rotation Rotation::follow(const TimedAzimuths& plots, double frequency, double start) {
  const double length = windowLength(plots, frequency);
  std::vector<BeamLine> lines = localLines(plots, frequency, length);
  if (lines.empty()) {
    throw std::invalid_argument("Rotation: the plots lie along a beam nowhere for ten turns, or are too few there");
  }
  dropWorst(lines);
  addEnds(lines, plots, frequency, length);
  lines.front().azimuth += wrapTwoPi(lines.front().at(0.0)) - lines.front().at(0.0);
  const std::vector<double> breaks = unwrap(lines, plots, 2.0 * length);
  std::vector<Knot> knots;
  const auto add = [&](const BeamLine& line, double time) { knots.push_back({start + time, line.at(time)}); };
  add(lines.front(), lines.front().time - length / 2.0);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const bool after_gap = i > 0 && lines[i].time - lines[i - 1].time > 2.0 * length;
    if (after_gap) add(lines[i - 1], lines[i - 1].time + length / 2.0);
    if (after_gap) add(lines[i], lines[i].time - length / 2.0);
    if (!std::isnan(breaks[i])) {
      constexpr double kLeap = 0.0005;  // [s], half of it
      add(lines[i - 1], breaks[i] - kLeap);
      add(lines[i], breaks[i] + kLeap);
    }
    add(lines[i], lines[i].time);
  }
  add(lines.back(), lines.back().time + length / 2.0);
  Rotation rotation(std::move(knots));
  const auto steady = [&](const BeamLine& line) { return SteadyBeam{start + line.time, line.azimuth, line.rate}; };
  for (std::size_t i = 1; i < lines.size(); ++i)
    if (!std::isnan(breaks[i])) rotation.breaks_.push_back({start + breaks[i], steady(lines[i - 1]), steady(lines[i])});
  checkThatItExplains(rotation, plots, start);
  return rotation;
}

double Rotation::period() const {
  const Knot& first = knots_.front();
  const Knot& last = knots_.back();
  return kTwoPi * (last.time - first.time) / (last.unwrapped - first.unwrapped);
}

double Rotation::unwrappedAt(double time) const {
  const auto later = [](double t, const Knot& knot) { return t < knot.time; };
  const auto next = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, time, later);
  const auto before = next - 1;
  const double share = (time - before->time) / (next->time - before->time);
  return before->unwrapped + share * (next->unwrapped - before->unwrapped);
}

double Rotation::timeAt(double unwrapped) const {
  const auto later = [](double azimuth, const Knot& knot) { return azimuth < knot.unwrapped; };
  const auto next = std::upper_bound(knots_.begin() + 1, knots_.end() - 1, unwrapped, later);
  const auto before = next - 1;
  const double share = (unwrapped - before->unwrapped) / (next->unwrapped - before->unwrapped);
  return before->time + share * (next->time - before->time);
}

}  // namespace tws
