#pragma once

#include <ros/ros.h>

#include <cstdint>
#include <functional>

namespace tws_runtime {

constexpr std::uint32_t kUnbounded = 0;  ///< queue

/// Hears messages until the condition holds. False: it does not within so many seconds.
inline bool waitFor(const std::function<bool()>& condition, double seconds = 60.0) {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (!condition() && ros::WallTime::now() < end) {
    ros::spinOnce();
    ros::WallDuration(0.001).sleep();
  }
  return condition();
}

}  // namespace tws_runtime
