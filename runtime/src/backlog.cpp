#include "backlog.h"

#include <algorithm>
#include <utility>

namespace tws_runtime {
namespace {

constexpr double kStandstill = 0.5;      // [s of wall time]
constexpr double kQuiet = 0.3;           // [s of wall time]
constexpr double kLongest = 10.0;        // after a standstill [s of wall time]
constexpr double kSilence = 2.0;         // [s of wall time]
constexpr double kUsualPauses = 3.0;     // a silence is longer than so many
constexpr int kKnown = 8;                // messages, by which a topic's pause is known
constexpr double kLongestAwaited = 5.0;  // after a silence [s of wall time]
constexpr double kOld = 1.0;             // more than usual [s of data time]
constexpr double kForget = 0.98;         // of what is usual, with each message

/// The largest of late, which slowly forgets.
void learnLargest(double& usual, double value) { usual = std::max(value, kForget * usual + (1.0 - kForget) * value); }

}  // namespace

std::size_t Backlog::addTopic() {
  topics_.emplace_back();
  return topics_.size() - 1;
}

std::optional<double> Backlog::beat(double wall) {
  const double pause = wall - beat_.value_or(wall);
  beat_ = wall;
  if (pause <= kStandstill || (open_ && !after_silence_)) return std::nullopt;
  open_ = true;
  after_silence_ = complete_ = false;
  opened_ = old_ = wall;
  return pause;
}

bool Backlog::keep(std::size_t index, double stamp, double wall, Give give) {
  Topic& topic = topics_[index];
  if (!open_ && isSilent(topic, wall)) openAfterSilence(wall);
  newest_ = std::max(newest_, stamp);
  if (!open_) learn(topic, stamp, wall);
  if (newest_ - stamp > topic.usual_lag + kOld) old_ = wall;
  ++topic.heard;
  topic.wall = wall;
  topic.stamp = stamp;
  if (open_) kept_.emplace(stamp, std::move(give));
  return open_;
}

bool Backlog::isSilent(const Topic& topic, double wall) const {
  return topic.heard >= kKnown && wall - topic.wall > std::max(kSilence, kUsualPauses * topic.usual_pause);
}

bool Backlog::isBehind(const Topic& topic) const {
  return newest_ - topic.stamp > topic.usual_lag + topic.usual_step + kOld;
}

void Backlog::openAfterSilence(double wall) {
  open_ = after_silence_ = true;
  complete_ = false;
  opened_ = wall;
  for (Topic& topic : topics_) topic.awaited = isSilent(topic, wall);
}

void Backlog::learn(Topic& topic, double stamp, double wall) {
  learnLargest(topic.usual_lag, newest_ - stamp);
  if (topic.heard == 0) return;
  learnLargest(topic.usual_step, stamp - topic.stamp);
  learnLargest(topic.usual_pause, wall - topic.wall);
}

bool Backlog::hasCome(double wall) const {
  if (!after_silence_) return wall - old_ >= kQuiet || wall - opened_ >= kLongest;
  const auto is_missed = [this](const Topic& topic) { return topic.awaited && isBehind(topic); };
  return wall - opened_ >= kLongestAwaited ||
         (wall - opened_ >= kQuiet && std::none_of(topics_.begin(), topics_.end(), is_missed));
}

std::optional<Backlog::Give> Backlog::take(double wall) {
  if (!open_) return std::nullopt;
  complete_ = complete_ || hasCome(wall);
  if (!complete_) return std::nullopt;
  if (kept_.empty()) {
    open_ = after_silence_ = false;
    return std::nullopt;
  }
  Give give = std::move(kept_.begin()->second);
  kept_.erase(kept_.begin());
  return give;
}

}  // namespace tws_runtime
