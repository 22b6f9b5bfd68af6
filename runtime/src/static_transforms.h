#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <tf2_msgs/TFMessage.h>

#include <algorithm>

namespace tws_runtime {

/// Adds `transform`, or puts it in the place of the one with the same child frame. A latched topic repeats its last
/// message only, so the last message must hold all of a node's transforms.
inline void addTransform(tf2_msgs::TFMessage& all, const geometry_msgs::TransformStamped& transform) {
  const auto same = [&](const auto& other) { return other.child_frame_id == transform.child_frame_id; };
  const auto found = std::find_if(all.transforms.begin(), all.transforms.end(), same);
  if (found == all.transforms.end())
    all.transforms.push_back(transform);
  else
    *found = transform;
}

}  // namespace tws_runtime
