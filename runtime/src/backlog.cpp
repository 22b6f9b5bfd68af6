#include "backlog.h"

#include <algorithm>
#include <utility>

namespace tws_runtime {
namespace {

constexpr double kStandstill = 0.5;  // [s of wall time]
constexpr double kQuiet = 0.3;       // [s of wall time]
constexpr double kLongest = 10.0;    // [s of wall time]
constexpr double kOld = 1.0;         // more than usual [s of data time]
constexpr double kForget = 0.98;     // of the usual lag, with each message

}  // namespace

std::size_t Backlog::addTopic() {
  usual_lag_.push_back(0.0);
  return usual_lag_.size() - 1;
}

std::optional<double> Backlog::beat(double wall) {
  const double pause = wall - beat_.value_or(wall);
  beat_ = wall;
  if (pause <= kStandstill || open_) return std::nullopt;
  open_ = true;
  complete_ = false;
  opened_ = old_ = wall;
  return pause;
}

bool Backlog::keep(std::size_t topic, double stamp, double wall, Give give) {
  newest_ = std::max(newest_, stamp);
  const double lag = newest_ - stamp;
  double& usual = usual_lag_[topic];
  if (!open_) {
    usual = std::max(lag, kForget * usual + (1.0 - kForget) * lag);
    return false;
  }
  if (lag > usual + kOld) old_ = wall;
  kept_.emplace(stamp, std::move(give));
  return true;
}

std::optional<Backlog::Give> Backlog::take(double wall) {
  if (!open_) return std::nullopt;
  complete_ = complete_ || wall - old_ >= kQuiet || wall - opened_ >= kLongest;
  if (!complete_) return std::nullopt;
  if (kept_.empty()) {
    open_ = false;
    return std::nullopt;
  }
  Give give = std::move(kept_.begin()->second);
  kept_.erase(kept_.begin());
  return give;
}

}  // namespace tws_runtime
