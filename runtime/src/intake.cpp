#include <tws_runtime/intake.h>

#include <tws_core/run_guard.h>
#include <tws_runtime/conversions.h>

#include <algorithm>
#include <deque>
#include <stdexcept>
#include <vector>

#include "sender_name.h"

namespace tws_runtime {

std::string whereText(const std::string& topic, ros::Time stamp) {
  return " in " + topic + " at " + std::to_string(stamp.toSec()) + " s";
}

class Intake::Impl {
 public:
  Impl(Bus& bus, double restart_limit, OnNewRun on_new_run)
      : bus_(bus), guard_(0, restart_limit), on_new_run_(std::move(on_new_run)) {}

  struct Topic {
    std::string name;
    StampOrder order;
    SenderName sender;
    ros::Time newest;
    bool held = false;  // the latest message is to be held back
  };

  std::size_t addTopic(Topic topic) {
    topics_.push_back(std::move(topic));
    return guard_.addStream();
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
    switch (guard_.judge(stream, toSeconds(stamp))) {
      case tws::RunGuard::Verdict::kTake:
        if (!held_.empty()) release(stream);
        return isInOrder(stream, stamp);
      case tws::RunGuard::Verdict::kHold:
        topic.held = true;
        count("stray messages", "the stamp is out of line: held back until others agree with it", stream, stamp);
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

Intake::Intake(Bus& bus, double restart_limit, OnNewRun on_new_run)
    : bus_(bus), impl_(std::make_unique<Impl>(bus, restart_limit, std::move(on_new_run))) {}
Intake::~Intake() = default;

bool Intake::isReleasing() const { return impl_->isReleasing(); }
const std::string& Intake::radarOf(const std::string& topic) const { return impl_->topic(topic).sender.name(); }

std::size_t Intake::addTopic(const std::string& name, const std::string& radar, StampOrder order) {
  return impl_->addTopic({name, order, SenderName(radar), {}});
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
