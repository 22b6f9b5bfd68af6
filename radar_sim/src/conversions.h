#pragma once

#include <geometry_msgs/TransformStamped.h>

#include <Eigen/Geometry>
#include <string>

namespace radar_sim {

/// The frame of the scenario's map.
constexpr const char* kMapFrame = "map";

/// A message with the fields x, y and z.
template <class M>
M toXyz(const Eigen::Vector3d& vector) {
  M message;
  message.x = vector.x();
  message.y = vector.y();
  message.z = vector.z();
  return message;
}

/// The pose of the radar's frame in the map.
geometry_msgs::TransformStamped toTransform(const Eigen::Isometry3d& map_to_radar, const std::string& radar);

}  // namespace radar_sim
