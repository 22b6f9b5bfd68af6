#include <tws_runtime/intake.h>

#include <tws_core/run_guard.h>
#include <tws_runtime/conversions.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "sender_name.h"

namespace tws_runtime {

std::string whereText(const std::string& topic, ros::Time stamp) {
  return " in " + topic + " at " + std::to_string(stamp.toSec()) + " s";
}

namespace {

/// No clock has come this far, and who computes with such stamps leaves what ros::Time can hold [s]: a day before 2^32.
constexpr std::uint32_t kEndOfTime = std::numeric_limits<std::uint32_t>::max() - 86400;

}  // namespace

class Intake::Impl {
 public:
  using Standing = tws::RunGuard::Standing;

  Impl(Bus& bus, double restart_limit, OnNewRun on_new_run, double skew_limit)
      : bus_(bus), guard_(0, restart_limit, skew_limit), on_new_run_(std::move(on_new_run)) {}

  struct Topic {
    std::string name;
    StampOrder order;
    SenderName sender;
    std::string radar;
    ros::Time newest = {};
    bool held = false;  // the latest message is to be held back
    Standing standing = Standing::kInLine;
  };

  /// Topics of one radar are one source.
  std::size_t addTopic(Topic topic) {
    const auto is_its = [&](const Topic& other) { return !topic.radar.empty() && other.radar == topic.radar; };
    const auto found = std::find_if(topics_.begin(), topics_.end(), is_its);
    const auto other = static_cast<std::size_t>(found - topics_.begin());
    const auto source = found == topics_.end() ? std::nullopt : std::optional<std::size_t>(guard_.sourceOf(other));
    topics_.push_back(std::move(topic));
    return guard_.addStream(source);
  }

  Topic& topic(std::size_t stream) { return topics_[stream]; }
  const Topic& topic(const std::string& name) const {
    const auto is_it = [&](const Topic& topic) { return topic.name == name; };
    const auto found = std::find_if(topics_.begin(), topics_.end(), is_it);
    if (found == topics_.end()) throw std::invalid_argument("the intake has no topic " + name);
    return *found;
  }

  void count(const char* counter, const std::string& what, std::size_t stream, ros::Time stamp) {
    bus_.counter(counter).add(what + whereText(topics_[stream].name, stamp));
  }

  /// Whether a message is to be given now.
  bool judge(std::size_t stream, ros::Time stamp) {
    Topic& topic = topics_[stream];
    topic.held = false;
    if (stamp.sec >= kEndOfTime) {
      count("bad messages", "a stamp at the end of time", stream, stamp);
      return false;
    }
    const ros::Time now = bus_.now();
    const auto clock = now.isZero() ? std::nullopt : std::optional<double>(toSeconds(now));
    const tws::RunGuard::Verdict verdict = guard_.judge(stream, toSeconds(stamp), clock);
    reportStanding(stream, stamp);
    switch (verdict) {
      case tws::RunGuard::Verdict::kTake:
        if (!held_.empty()) release(stream);
        return isInOrder(stream, stamp);
      case tws::RunGuard::Verdict::kHold:
        topic.held = true;
        countHeld(stream, stamp);
        return false;
      case tws::RunGuard::Verdict::kNewRun:
        count("new runs", "time has gone back", stream, stamp);
        for (Topic& each : topics_) each.newest = ros::Time();
        if (on_new_run_) on_new_run_(toSeconds(earliest(stamp)));
        break;
      case tws::RunGuard::Verdict::kResume:
        count("pauses", "time goes on behind a pause", stream, stamp);
        break;
    }
    releaseAgreeing();
    return isInOrder(stream, stamp);
  }

  bool isReleasing() const { return releasing_; }

  void hold(std::size_t stream, ros::Time stamp, std::function<void()> give) {
    constexpr std::ptrdiff_t kMostHeld = 512;  // of a topic
    const auto is_own = [&](const Held& held) { return held.stream == stream; };
    if (std::count_if(held_.begin(), held_.end(), is_own) >= kMostHeld)
      held_.erase(std::find_if(held_.begin(), held_.end(), is_own));
    held_.push_back({stream, stamp, std::move(give)});
  }

 private:
  struct Held {
    std::size_t stream;
    ros::Time stamp;
    std::function<void()> give;
  };

  void reportStanding(std::size_t stream, ros::Time stamp) {
    const Standing before = topics_[stream].standing;
    const Standing now = topics_[stream].standing = guard_.standing(stream);
    if (now == before) return;
    const std::string off = std::to_string(std::abs(toSeconds(stamp) - *guard_.newest())) + " s";
    if (now == Standing::kSetAside)
      count("set aside", "its clock is " + off + " off the others': left out until it agrees with them", stream, stamp);
    if (now == Standing::kLagging) count("backlogs", off + " behind the others: taken in all the same", stream, stamp);
    if (before == Standing::kSetAside && now == Standing::kInLine)
      count("joined again", "its clock agrees with the others again", stream, stamp);
  }

  void countHeld(std::size_t stream, ros::Time stamp) {
    if (topics_[stream].standing == Standing::kRivalled)
      count("messages of a second publisher",
            "messages of another time come between: left out; is the radar, or a bag, played twice?", stream, stamp);
    else
      count("stray messages", "the stamp is out of line: held back until others agree with it", stream, stamp);
  }

  bool isInOrder(std::size_t stream, ros::Time stamp) {
    Topic& topic = topics_[stream];
    const bool back = topic.order != StampOrder::kAny && stamp < topic.newest;
    const bool same = topic.order == StampOrder::kForward && stamp == topic.newest;
    if (back || same) count("late messages", back ? "the stamp goes back" : "the stamp came before", stream, stamp);
    topic.newest = std::max(topic.newest, stamp);
    return !back && !same;
  }

  ros::Time earliest(ros::Time stamp) const {
    for (const Held& held : held_)
      if (guard_.agrees(toSeconds(held.stamp))) stamp = std::min(stamp, held.stamp);
    return stamp;
  }

  /// The stream is in line: what was held back of it is stray.
  void release(std::size_t stream) {
    const auto is_own = [&](const Held& held) { return held.stream == stream; };
    held_.erase(std::remove_if(held_.begin(), held_.end(), is_own), held_.end());
  }

  void releaseAgreeing() {
    std::deque<Held> held;
    held.swap(held_);
    releasing_ = true;
    for (Held& each : held) {
      if (!guard_.agrees(toSeconds(each.stamp))) continue;
      if (isInOrder(each.stream, each.stamp)) each.give();
    }
    releasing_ = false;
  }

  Bus& bus_;
  tws::RunGuard guard_;
  OnNewRun on_new_run_;
  std::vector<Topic> topics_;
  std::deque<Held> held_;  // in the order in which they came
  bool releasing_ = false;
};

Intake::Intake(Bus& bus, double restart_limit, OnNewRun on_new_run, double skew_limit)
    : bus_(bus), impl_(std::make_unique<Impl>(bus, restart_limit, std::move(on_new_run), skew_limit)) {}
Intake::~Intake() = default;

bool Intake::isReleasing() const { return impl_->isReleasing(); }
const std::string& Intake::radarOf(const std::string& topic) const { return impl_->topic(topic).sender.name(); }

std::size_t Intake::addTopic(const std::string& name, const std::string& radar, StampOrder order) {
  return impl_->addTopic({name, order, SenderName(radar), radar});
}

bool Intake::isFrom(std::size_t stream, const std::string& name, ros::Time stamp) {
  SenderName& sender = impl_->topic(stream).sender;
  if (sender.accepts(name)) return true;
  refuse(stream, "radar '" + name + "', expected '" + sender.name() + "'", stamp);
  return false;
}

void Intake::refuse(std::size_t stream, const std::string& fault, ros::Time stamp) {
  impl_->count("bad messages", fault, stream, stamp);
}

bool Intake::judge(std::size_t stream, ros::Time stamp) { return impl_->judge(stream, stamp); }
bool Intake::isHeld(std::size_t stream) const { return impl_->topic(stream).held; }
void Intake::hold(std::size_t stream, ros::Time stamp, std::function<void()> give) {
  impl_->hold(stream, stamp, std::move(give));
}

}  // namespace tws_runtime
