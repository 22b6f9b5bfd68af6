#include <tws_runtime/moving_frames.h>

#include <tws_runtime/conversions.h>

#include <algorithm>

namespace tws_runtime {

MovingFrames::MovingFrames(Bus& bus) : bus_(bus) {
  bus.subscribe<tf2_msgs::TFMessage>("/tf_static", [this](const auto& message) {
    for (const auto& transform : message.transforms) take(transform, true);
  });
  bus.subscribe<tf2_msgs::TFMessage>("/tf", [this](const auto& message) { onMoving(message); });
}

/// A time that goes back by more begins anew: else the old run's poses would be the latest until it has come so far.
void MovingFrames::onMoving(const tf2_msgs::TFMessage& message) {
  constexpr double kNewRun = 5.0;  // [s]
  for (const auto& transform : message.transforms) {
    if (secondsBetween(transform.header.stamp, latest_) > kNewRun) {
      transforms_.clear();  // those that stand, stay
      latest_ = transform.header.stamp;
    }
    latest_ = std::max(latest_, transform.header.stamp);
    take(transform, false);
  }
}

void MovingFrames::take(const geometry_msgs::TransformStamped& transform, bool is_static) {
  if (!transforms_.setTransform(transform, "tf", is_static))
    bus_.counter("refused transforms").add(transform.header.frame_id + " to " + transform.child_frame_id);
}

ros::Time MovingFrames::timeFor(const std::string& to, const std::string& from, ros::Time time) const {
  return transforms_.canTransform(to, from, time) ? time : ros::Time();
}

}  // namespace tws_runtime
