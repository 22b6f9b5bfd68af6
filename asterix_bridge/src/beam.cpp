#include "beam.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <vector>

#include <tws_core/angles.h>

namespace asterix_bridge {
namespace {

constexpr double kTurnsKept = 12.0;
constexpr double kOften = 1.0;            // learns at most [s]
constexpr double kLongestSearch = 400.0;  // [s]
constexpr double kLeastPeriod = 0.2;      // [s]
constexpr double kGreatestPeriod = 120.0;

bool isPeriod(double period) { return period >= kLeastPeriod && period <= kGreatestPeriod; }

}  // namespace

void Beam::add(double time, double azimuth) {
  points_.push_back({time, azimuth});
  if (latest_) break_.add(points_.back(), *latest_);
}

// The period is the least of the last intervals but for jitter: a mark may be lost, seldom is one too many.
void Beam::addNorth(double time) {
  constexpr std::size_t kMost = 8;
  add(time, 0.0);
  if (!norths_.empty() && std::abs(time - norths_.back()) < kLeastPeriod / 2.0) return;  // north and sector mark in one
  norths_.push_back(time);
  if (norths_.size() > kMost) norths_.pop_front();
  std::vector<double> intervals;
  for (std::size_t i = 1; i < norths_.size(); ++i) intervals.push_back(norths_[i] - norths_[i - 1]);
  std::sort(intervals.begin(), intervals.end());
  if (intervals.size() >= 2 && !line_ && isPeriod(intervals[intervals.size() / 2]))
    period_ = intervals[(intervals.size() - 1) / 2];
}

void Beam::setNominalPeriod(double period) {
  if (!isPeriod(period)) return;
  nominal_ = period;
  if (!line_) period_ = period;
}

double Beam::period() const {
  if (line_) return tws::kTwoPi / line_->rate;
  return period_.value_or(std::numeric_limits<double>::quiet_NaN());
}

// Once a turn; until the beam is known, as often as there is clearly more to learn from.
bool Beam::isDue(double now) const {
  constexpr double kMore = 0.05;
  if (!learned_) return true;
  const double seen = points_.empty() ? 0.0 : now - points_.front().time;
  return now - *learned_ >= (line_ ? std::max(*period_, kOften) : std::max(kOften, kMore * seen));
}

bool Beam::learn(double now, double fixed) {
  if (!isDue(now) || (line_ && doubtfulSince())) return isKnown();
  learned_ = now;
  const double turns = period_ ? kTurnsKept * *period_ : kLongestSearch;
  forgetBefore(line_ ? std::min(now - turns, fixed - turns / 2.0) : now - turns);
  if (const auto rotation = fit()) {
    steer(*rotation, fixed);
    watch(*rotation);
  }
  return isKnown();
}

bool Beam::learnNow(double now, double fixed) {
  learned_.reset();
  return learn(now, fixed);
}

// Nothing: there is not enough to see a rotation, or what was added shows none. A period that is known may be outdated.
std::optional<tws::Rotation> Beam::fit() const {
  constexpr std::size_t kFew = 5, kEnough = 30;
  const std::vector<tws::TimedAzimuth> points(points_.begin(), points_.end());
  try {
    if (period_ && points.size() >= kFew) return tws::Rotation::fromPlots(points, *period_);
  } catch (const std::invalid_argument&) {
  }
  try {
    if (!line_ && points.size() >= kEnough) return tws::Rotation::fromPlots(points);
  } catch (const std::invalid_argument&) {
  }
  return std::nullopt;
}

// How the beam turns by the latest of the data, and how far off that these are.
void Beam::watch(const tws::Rotation& rotation) {
  const double time = points_.back().time;
  const double period = rotation.period();
  const double azimuth = rotation.unwrappedAt(time);
  latest_ = tws::SteadyBeam{time, azimuth, (azimuth - rotation.unwrappedAt(time - period)) / period};
  std::vector<double> residuals;
  for (const auto& point : points_)
    residuals.push_back(std::abs(tws::angularDifference(point.azimuth, rotation.unwrappedAt(point.time))));
  const auto middle = residuals.begin() + static_cast<std::ptrdiff_t>(residuals.size() / 2);
  std::nth_element(residuals.begin(), middle, residuals.end());
  break_.setScatter(*middle);
}

std::optional<tws::SteadyBeam> Beam::findBreak() {
  if (!line_ || !break_.since()) return std::nullopt;
  const auto found = break_.find(*latest_, nominal_);
  if (found && isPeriod(tws::kTwoPi / found->rate)) return found;
  return std::nullopt;
}

void Beam::turnAlong(const tws::SteadyBeam& line) {
  line_ = latest_ = line;
  period_ = tws::kTwoPi / line.rate;
  points_ = break_.reports();
  norths_.clear();
  break_.clear();
}

void Beam::raise(double time, double least) {
  const double below = least - line_->azimuthAt(time);
  if (below > 0.0) line_->azimuth += tws::kTwoPi * std::ceil(below / tws::kTwoPi);
}

bool Beam::isLost() const {
  constexpr std::size_t kMany = 30;
  constexpr double kTurns = 4.0, kLong = 10.0;
  const auto since = break_.since();
  return since && break_.reports().size() >= kMany &&
         std::abs(points_.back().time - *since) > std::max(kLong, kTurns * *period_);
}

std::string Beam::whyUnknown() const {
  const auto earlier = [](const auto& a, const auto& b) { return a.time < b.time; };
  if (points_.empty()) return "there are none with a time";
  const auto ends = std::minmax_element(points_.begin(), points_.end(), earlier);
  if (ends.second->time - ends.first->time < kLeastPeriod) return "all have the same time, or nearly so";
  std::vector<tws::TimedAzimuth> mirrored(points_.begin(), points_.end());
  for (auto& point : mirrored) point.azimuth = tws::kTwoPi - point.azimuth;
  try {
    const double period = tws::Rotation::fromPlots(mirrored).period();
    char text[80];
    std::snprintf(text, sizeof text, "the antenna turns counter-clockwise, once in %.3f s: that is not read", period);
    return text;
  } catch (const std::invalid_argument&) {
    return "they do not show how it turns; periods of 0.2 to 120 s are found, antennas that scan to and fro are not "
           "read";
  }
}

void Beam::steer(const tws::Rotation& rotation, double fixed) {
  const double time = line_ ? fixed : points_.back().time;
  const double period = rotation.period();
  const double azimuth = rotation.unwrappedAt(time);
  const double rate = (rotation.unwrappedAt(time + period) - azimuth) / period;
  period_ = period;
  if (line_) {
    const double now = azimuthAt(time);
    const double error = tws::angularDifference(azimuth, now);
    line_ = tws::SteadyBeam{time, now, rate + error / std::max(period, kOften)};
    return;
  }
  // One turn more, so that a report a little before the first one has no negative azimuth.
  double start = azimuth + tws::kTwoPi * (1.0 - std::floor(rotation.unwrappedAt(points_.front().time) / tws::kTwoPi));
  if (before_interruption_) {
    const double expected = before_interruption_->azimuthAt(time);
    start = expected + tws::angularDifference(azimuth, expected);
  }
  line_ = tws::SteadyBeam{time, start, rate};
}

void Beam::forgetBefore(double time) {
  while (!points_.empty() && points_.front().time < time) points_.pop_front();
}

void Beam::interrupt() {
  if (line_) before_interruption_ = line_;
  line_.reset();
  latest_.reset();
  break_.clear();
  learned_.reset();
  points_.clear();
  norths_.clear();
}

}  // namespace asterix_bridge
