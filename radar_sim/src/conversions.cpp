#include "conversions.h"

#include <cmath>

#include <tws_core/sectors.h>
#include <tws_runtime/conversions.h>

namespace radar_sim {
namespace {

template <class M>
M toXyz(const Eigen::Vector3d& vector) {
  M message;
  message.x = vector.x();
  message.y = vector.y();
  message.z = vector.z();
  return message;
}

std::uint8_t toKind(TargetKind kind) {
  switch (kind) {
    case TargetKind::kAircraft:
      return tws_msgs::TruthTarget::AIRCRAFT;
    case TargetKind::kShip:
      return tws_msgs::TruthTarget::SHIP;
    case TargetKind::kClutter:
      return tws_msgs::TruthTarget::CLUTTER;
    case TargetKind::kSlowMover:
      break;
  }
  return tws_msgs::TruthTarget::SLOW_MOVER;
}

tws_msgs::TruthTarget toTruthTarget(const TruthReport::Entry& entry, const Target& target) {
  constexpr std::uint16_t kCodeUnknown = 65535;
  tws_msgs::TruthTarget message;
  message.id = static_cast<std::uint32_t>(entry.target);
  message.name = target.name;
  message.kind = toKind(target.kind);
  message.position = toXyz<geometry_msgs::Point>(entry.state.position);
  message.velocity = toXyz<geometry_msgs::Vector3>(entry.state.velocity);
  const bool is_stated = !std::isnan(target.reflection.detection_probability);
  message.rcs = is_stated ? tws::Plot::kUnknown : target.reflection.rcs;
  message.mode_3a = kCodeUnknown;
  for (const TruthReport::Sighting& sighting : entry.sightings) {
    message.slant_range.push_back(sighting.slant_range);
    message.azimuth.push_back(sighting.azimuth);
    message.detection_probability.push_back(sighting.detection_probability);
  }
  return message;
}

}  // namespace

tws_msgs::SectorMark toSectorMark(const SectorReport& report, const Simulation& simulation) {
  tws_msgs::SectorMark mark;
  mark.radar = simulation.radars()[report.radar].params().name;
  mark.header.stamp = tws_runtime::toTime(report.sector.leave_time);
  mark.header.frame_id = mark.radar;
  mark.sector = static_cast<std::uint8_t>((report.sector.sector + 1) % tws::kSectors);
  mark.running_sector = static_cast<std::uint32_t>(report.sector.running + 1);
  mark.closed_sector = static_cast<std::uint8_t>(report.sector.sector);
  mark.closed_count = static_cast<std::uint32_t>(report.sector.plots.size());
  mark.running_count = static_cast<std::uint32_t>(report.plot_count);
  mark.rotation_period = report.rotation_period;
  for (const SectorReport::Beam& beam : report.others) {
    mark.other_radars.push_back(simulation.radars()[beam.radar].params().name);
    mark.other_azimuths.push_back(beam.azimuth);
  }
  return mark;
}

tws_msgs::Truth toTruth(const TruthReport& report, const Simulation& simulation) {
  tws_msgs::Truth truth;
  truth.header.stamp = tws_runtime::toTime(report.time);
  truth.header.frame_id = kMapFrame;
  for (const RotatingRadar& radar : simulation.radars()) truth.radars.push_back(radar.params().name);
  for (const TruthReport::Entry& entry : report.entries) {
    truth.targets.push_back(toTruthTarget(entry, simulation.targets()[entry.target]));
  }
  return truth;
}

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
