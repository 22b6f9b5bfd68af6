#include "core/own_ship.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <tws_core/units.h>

namespace adit_tracker {
namespace {

constexpr double kSlack = 20.0, kFastest = 50.0;                                         // [m], [m/s]
constexpr double kHeadingSlack = tws::radians(20.0), kFastestTurn = tws::radians(45.0);  // [rad], [rad/s]
constexpr int kEnough = 3;                                                               // refused poses that agree
constexpr double kFarthest = 1e7;                                                        // from the frame's origin [m]

bool isNumber(double time, const Pose& pose) {
  return std::isfinite(time) && std::abs(pose.x) <= kFarthest && std::abs(pose.y) <= kFarthest &&
         std::isfinite(pose.heading);
}

}  // namespace

/// Can a ship have got from one to the other?
bool OwnShip::agree(const Timed& a, const Timed& b) {
  const double dt = b.time - a.time;
  return dt > 0.0 && std::hypot(b.pose.x - a.pose.x, b.pose.y - a.pose.y) <= kSlack + kFastest * dt &&
         std::abs(tws::angularDifference(b.pose.heading, a.pose.heading)) <= kHeadingSlack + kFastestTurn * dt;
}

bool OwnShip::isSame(const Timed& a, const Timed& b) {
  return a.time == b.time && a.pose.x == b.pose.x && a.pose.y == b.pose.y && a.pose.heading == b.pose.heading;
}

std::string OwnShip::add(double time, const Pose& pose) {
  if (!isNumber(time, pose)) return "holds no number, or one beyond 10 000 km";
  const Timed next{time, pose};
  if (!poses_.empty() && isSame(poses_.back(), next)) return "";
  if (poses_.empty() || agree(poses_.back(), next)) {
    poses_.push_back(next);
    refused_.reset();
    agreeing_ = 0;
    return "";
  }
  agreeing_ = refused_ && agree(*refused_, next) ? agreeing_ + 1 : 1;
  refused_ = next;
  if (agreeing_ < kEnough) {
    if (time <= poses_.back().time) return "does not come after the one before";
    char text[100];
    std::snprintf(text, sizeof text, "lies %.0f m and %.0f deg from the one before, %.2f s later",
                  std::hypot(pose.x - poses_.back().pose.x, pose.y - poses_.back().pose.y),
                  tws::degrees(std::abs(tws::angularDifference(pose.heading, poses_.back().pose.heading))),
                  time - poses_.back().time);
    return text;
  }
  restart(next);
  return "";
}

void OwnShip::restart(const Timed& from) {
  if (from.time <= poses_.back().time) poses_.clear();
  poses_.push_back(from);
  poses_.back().after_gap = true;
  refused_.reset();
  agreeing_ = 0;
}

/// Does pose i go on from the one before?
bool OwnShip::isConnected(std::size_t i) const {
  return i > 0 && !poses_[i].after_gap && poses_[i].time - poses_[i - 1].time <= kLongestGap;
}

/// Before or after pose i, as the ship moved there over a second: less shows the errors of places and not its speed.
std::optional<Pose> OwnShip::beyond(std::size_t i, double time) const {
  constexpr double kLongEnough = 1.0, kTooShort = 0.5;  // [s]
  const Timed& last = poses_[i];
  if (std::abs(time - last.time) > kLongestExtrapolation) return std::nullopt;
  std::size_t j = i;
  const auto span = [&] { return std::abs(poses_[j].time - last.time); };
  if (time > last.time)
    while (span() < kLongEnough && isConnected(j)) --j;
  else
    while (span() < kLongEnough && j + 1 < poses_.size() && isConnected(j + 1)) ++j;
  if (span() < kTooShort) return last.pose;
  return between(last.pose, poses_[j].pose, (time - last.time) / (poses_[j].time - last.time));
}

std::optional<Pose> OwnShip::at(double time) const {
  const auto after =
      std::lower_bound(poses_.begin(), poses_.end(), time, [](const Timed& pose, double t) { return pose.time < t; });
  const auto i = static_cast<std::size_t>(after - poses_.begin());
  if (i < poses_.size() && poses_[i].time == time) return poses_[i].pose;
  if (i < poses_.size() && isConnected(i)) {
    const Timed& before = poses_[i - 1];
    return between(before.pose, poses_[i].pose, (time - before.time) / (poses_[i].time - before.time));
  }
  std::optional<Pose> pose;
  if (i > 0) pose = beyond(i - 1, time);
  if (!pose && i < poses_.size()) pose = beyond(i, time);
  return pose;
}

std::optional<Passage> OwnShip::over(double begin, double end) const {
  const auto from = at(begin), to = at(end);
  if (!from || !to) return std::nullopt;
  return Passage{begin, end, *from, *to};
}

void OwnShip::forgetBefore(double time) {
  while (poses_.size() > 2 && poses_[1].time < time) poses_.pop_front();
}

}  // namespace adit_tracker
