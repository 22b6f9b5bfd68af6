#pragma once

#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>
#include <tws_runtime/bus.h>

namespace tws_runtime {

/// All transforms, of frames that move (/tf), too: for what is drawn. The Bus has those that stand.
class MovingFrames {
 public:
  explicit MovingFrames(Bus& bus);

  const tf2::BufferCore& transforms() const { return transforms_; }
  /// When to ask for the transform between two frames: at that time, or, if it is not known then, the latest.
  ros::Time timeFor(const std::string& to, const std::string& from, ros::Time time) const;

 private:
  void onMoving(const tf2_msgs::TFMessage& message);
  void take(const geometry_msgs::TransformStamped& transform, bool is_static);

  Bus& bus_;
  tf2::BufferCore transforms_;
  ros::Time latest_;
};

}  // namespace tws_runtime
