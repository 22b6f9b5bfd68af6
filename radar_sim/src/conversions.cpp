#include "conversions.h"

namespace radar_sim {

geometry_msgs::TransformStamped toTransform(const Eigen::Isometry3d& map_to_radar, const std::string& radar) {
  const Eigen::Isometry3d pose = map_to_radar.inverse();
  const Eigen::Quaterniond rotation = Eigen::Quaterniond(pose.linear()).normalized();
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = kMapFrame;
  transform.child_frame_id = radar;
  transform.transform.translation = toXyz<geometry_msgs::Vector3>(pose.translation());
  transform.transform.rotation.x = rotation.x();
  transform.transform.rotation.y = rotation.y();
  transform.transform.rotation.z = rotation.z();
  transform.transform.rotation.w = rotation.w();
  return transform;
}

}  // namespace radar_sim
