#include "beam.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include <tws_core/angles.h>
#include <tws_core/beam_sense.h>
#include <tws_core/median.h>

namespace asterix_bridge {
namespace {

constexpr double kTurnsKept = 12.0;
constexpr double kOften = 1.0;            // learns at most [s]
constexpr double kPatience = 60.0;        // [s]
constexpr double kLongestSearch = 400.0;  // [s]
constexpr double kLeastPeriod = 0.2;      // [s]
constexpr double kGreatestPeriod = 120.0;

bool isPeriod(double period) { return period >= kLeastPeriod && period <= kGreatestPeriod; }

}  // namespace

void Beam::add(double time, double azimuth) {
  constexpr std::size_t kLatest = 200;
  points_.push_back({time, azimuth});
  latest_points_.push_back(points_.back());
  if (latest_points_.size() > kLatest) latest_points_.pop_front();
  if (latest_) break_.add(points_.back(), *latest_);
}

void Beam::addMark(double time, double azimuth) {
  constexpr std::size_t kFew = 5, kMost = 16;
  add(time, azimuth);
  const auto before = mark_;
  mark_ = tws::TimedAzimuth{time, azimuth};
  if (!before) return;
  const double width = tws::wrapTwoPi(azimuth - before->azimuth);
  const double period = (time - before->time) * tws::kTwoPi / width;
  if (width > tws::kPi || !isPeriod(period)) return;
  periods_.push_back(period);
  if (periods_.size() > kMost) periods_.pop_front();
  if (periods_.size() >= kFew && !line_ && nominal_ == 0.0) period_ = tws::median({periods_.begin(), periods_.end()});
}

// The period is the least of the last intervals but for jitter: a mark may be lost, seldom is one too many.
void Beam::addNorth(double time) {
  constexpr std::size_t kMost = 8;
  addMark(time, 0.0);
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
  if (!line_ && scansToAndFro()) return false;
  const double turns = period_ ? kTurnsKept * *period_ : kLongestSearch;
  forgetBefore(line_ ? std::min(now - turns, fixed - turns / 2.0) : now - turns);
  if (auto rotation = fit()) {
    rotation_ = std::move(rotation);
    period_ = rotation_->period();
    line_ ? followFrom(fixed) : begin();
    watch();
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
  const tws::TimedAzimuths points(points_.begin(), points_.end());
  try {
    if (period_ && points.size() >= kFew) return tws::Rotation::fromPlots(points, *period_);
  } catch (const std::invalid_argument&) {
  }
  try {
    if (line_ || points.size() < kEnough || isAboutToBeTold()) return std::nullopt;
    const tws::Rotation found = tws::Rotation::fromPlots(points);
    if (isBelievable(found.period())) return found;
  } catch (const std::invalid_argument&) {
  }
  return std::nullopt;
}

// Less than two points a turn may be plots at even steps of a slower antenna, of which more must be seen.
bool Beam::isBelievable(double period) const {
  const double span = points_.back().time - points_.front().time;
  return static_cast<double>(points_.size()) * period > 2.0 * span || span > kPatience;
}

// Two north marks more, and the period is known for certain: plots at even steps agree with periods that are none.
bool Beam::isAboutToBeTold() const {
  return !period_ && !norths_.empty() && points_.back().time - norths_.front() < kPatience;
}

// How the beam turns by the latest of the data, and how far off that these are.
void Beam::watch() {
  const double time = points_.back().time;
  const double azimuth = rotation_->unwrappedAt(time);
  latest_ = tws::SteadyBeam{time, azimuth, (azimuth - rotation_->unwrappedAt(time - *period_)) / *period_};
  std::vector<double> residuals;
  for (const auto& point : points_)
    residuals.push_back(std::abs(tws::angularDifference(point.azimuth, rotation_->unwrappedAt(point.time))));
  break_.setScatter(tws::median(std::move(residuals)));
}

std::optional<tws::SteadyBeam> Beam::findBreak() {
  if (!line_ || !break_.since()) return std::nullopt;
  const auto found = break_.find(*latest_, nominal_);
  if (found && isPeriod(tws::kTwoPi / found->rate) && !scansToAndFro()) return found;
  return std::nullopt;
}

void Beam::turnAlong(const tws::SteadyBeam& line) {
  line_ = latest_ = line;
  rotation_.reset();
  period_ = tws::kTwoPi / line.rate;
  points_ = break_.reports();
  norths_.clear();
  mark_.reset();
  periods_.clear();
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
  if (!since) return false;
  const double ago = std::abs(points_.back().time - *since);
  return (break_.reports().size() >= kMany && ago > std::max(kLong, kTurns * *period_)) || scansToAndFro();
}

std::string Beam::whyUnknown() const {
  const auto earlier = [](const auto& a, const auto& b) { return a.time < b.time; };
  if (points_.empty()) return "there are none with a time";
  const auto ends = std::minmax_element(points_.begin(), points_.end(), earlier);
  if (ends.second->time - ends.first->time < kLeastPeriod) return "all have the same time, or nearly so";
  const std::string other =
      tws::otherScanOf(scansToAndFro() ? tws::TimedAzimuths(latest_points_.begin(), latest_points_.end())
                                       : tws::TimedAzimuths(points_.begin(), points_.end()));
  return other.empty() ? "they do not show how it turns; periods of 0.2 to 120 s are found" : other;
}

bool Beam::scansToAndFro() const { return tws::scansToAndFro({latest_points_.begin(), latest_points_.end()}); }

namespace {

double rateAt(const tws::Rotation& rotation, double time) {
  const double period = rotation.period();
  return (rotation.unwrappedAt(time + period) - rotation.unwrappedAt(time)) / period;
}

}  // namespace

void Beam::begin() {
  const double time = points_.back().time;
  const double azimuth = rotation_->unwrappedAt(time);
  // One turn more, so that a report a little before the first one has no negative azimuth.
  const double first = rotation_->unwrappedAt(points_.front().time);
  double start = azimuth + tws::kTwoPi * (1.0 - std::floor(first / tws::kTwoPi));
  if (before_interruption_) {
    const double expected = before_interruption_->azimuthAt(time);
    start = expected + tws::angularDifference(azimuth, expected);
  }
  line_ = tws::SteadyBeam{time, start, rateAt(*rotation_, time)};
}

void Beam::followFrom(double time) {
  if (!rotation_) return;
  const double now = azimuthAt(time);
  const double error = tws::angularDifference(rotation_->unwrappedAt(time), now);
  line_ = tws::SteadyBeam{time, now, rateAt(*rotation_, time) + error / std::max(*period_, kOften)};
}

void Beam::startAt(double time) {
  if (!rotation_) return;
  const double near = azimuthAt(time);
  const double azimuth = near + tws::angularDifference(rotation_->unwrappedAt(time), near);
  line_ = tws::SteadyBeam{time, azimuth, rateAt(*rotation_, time)};
}

void Beam::forgetBefore(double time) {
  while (!points_.empty() && points_.front().time < time) points_.pop_front();
}

void Beam::interrupt() {
  if (line_) before_interruption_ = line_;
  line_.reset();
  rotation_.reset();
  latest_.reset();
  break_.clear();
  learned_.reset();
  points_.clear();
  norths_.clear();
  mark_.reset();
  periods_.clear();
}

}  // namespace asterix_bridge
