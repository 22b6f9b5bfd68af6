#include <tws_runtime/sites.h>

namespace tws_runtime {

std::optional<Site> awaitSite(Bus& bus, const std::string& frame, const std::string& radar_frame, bool patient,
                              const Site& otherwise) {
  std::string why;
  const std::optional<Site> site = findSite(bus.transforms(), frame, radar_frame, why);
  if (site || patient) return site;
  bus.counter("unknown sites").add("no transform from " + radar_frame + " to " + frame + ": " + why);
  return otherwise;
}

std::optional<Eigen::Isometry3d> findPose(const tf2::BufferCore& transforms, const std::string& to,
                                          const std::string& from, std::string& why) {
  if (!transforms.canTransform(to, from, ros::Time(0), &why)) return std::nullopt;
  const geometry_msgs::Transform transform = transforms.lookupTransform(to, from, ros::Time(0)).transform;
  const auto& r = transform.rotation;
  const auto& t = transform.translation;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(r.w, r.x, r.y, r.z).normalized().toRotationMatrix();
  pose.translation() << t.x, t.y, t.z;
  return pose;
}

}  // namespace tws_runtime
