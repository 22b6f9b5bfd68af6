#pragma once

#include <ros/time.h>
#include <tws_runtime/conversions.h>

#include <algorithm>

namespace tws_runtime {

/// How far one stamp may be off in a message that was damaged on its way [s].
constexpr double kStrays[] = {86400.0, -86400.0, 30.0, -30.0};

/// That far off, but not before the beginning of time.
inline ros::Time strayed(ros::Time stamp, double off) { return toTime(std::max(0.0, toSeconds(stamp) + off)); }

template <class M>
M withStrayStamp(M message, double off) {
  message.header.stamp = strayed(message.header.stamp, off);
  return message;
}

}  // namespace tws_runtime
