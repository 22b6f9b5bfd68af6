#include "beam.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <tws_core/angles.h>

namespace asterix_bridge {
namespace {

constexpr double kTurnsKept = 12.0;
constexpr double kLongestSearch = 90.0;  // [s]
constexpr double kLeastPeriod = 0.5;     // [s]
constexpr double kGreatestPeriod = 60.0;

bool isPeriod(double period) { return period >= kLeastPeriod && period <= kGreatestPeriod; }

}  // namespace

void Beam::add(double time, double azimuth) { points_.push_back({time, azimuth}); }

// The period is the least of the last intervals but for jitter: a mark may be lost, seldom is one too many.
void Beam::addNorth(double time) {
  constexpr std::size_t kMost = 8;
  add(time, 0.0);
  if (!norths_.empty() && std::abs(time - norths_.back()) < kLeastPeriod) return;  // north and sector mark in one
  norths_.push_back(time);
  if (norths_.size() > kMost) norths_.pop_front();
  std::vector<double> intervals;
  for (std::size_t i = 1; i < norths_.size(); ++i) intervals.push_back(norths_[i] - norths_[i - 1]);
  std::sort(intervals.begin(), intervals.end());
  if (intervals.size() >= 2 && !line_ && isPeriod(intervals[intervals.size() / 2]))
    period_ = intervals[(intervals.size() - 1) / 2];
}

void Beam::setNominalPeriod(double period) {
  if (!line_ && isPeriod(period)) period_ = period;
}

double Beam::period() const {
  if (line_) return tws::kTwoPi / line_->rate;
  return period_.value_or(std::numeric_limits<double>::quiet_NaN());
}

bool Beam::learn(double now, double fixed) {
  constexpr double kOften = 1.0;
  if (learned_ && now - *learned_ < (line_ ? *period_ : kOften)) return isKnown();
  learned_ = now;
  forgetBefore(now - (period_ ? kTurnsKept * *period_ : kLongestSearch));
  if (const auto rotation = fit()) steer(*rotation, fixed);
  return isKnown();
}

// Nothing: there is not enough to see a rotation, or what was added shows none.
std::optional<tws::Rotation> Beam::fit() const {
  constexpr std::size_t kFew = 5, kEnough = 30;
  if (points_.size() < (period_ ? kFew : kEnough)) return std::nullopt;
  const std::vector<tws::TimedAzimuth> points(points_.begin(), points_.end());
  try {
    return period_ ? tws::Rotation::fromPlots(points, *period_) : tws::Rotation::fromPlots(points);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
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
    line_ = tws::SteadyBeam{time, now, rate + error / period};
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
  learned_.reset();
  points_.clear();
  norths_.clear();
}

}  // namespace asterix_bridge
