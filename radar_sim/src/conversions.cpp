#include "conversions.h"

#include <cmath>
#include <limits>

#include <tws_core/sectors.h>
#include <tws_runtime/conversions.h>

#include "mode_c.h"

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

std::uint16_t codeOf(int code) {
  return code >= 0 ? static_cast<std::uint16_t>(code) : std::uint16_t{tws_msgs::SsrPlot::CODE_UNKNOWN};
}

std::uint16_t codeOf(const CodeReading& reading) { return codeOf(reading.code ? int{*reading.code} : -1); }

/// Two octal digits, of which the second has two bits.
std::uint16_t mode1Of(const CodeReading& reading) {
  if (!reading.code) return tws_msgs::SsrPlot::CODE_UNKNOWN;
  return static_cast<std::uint16_t>((*reading.code >> 9 & 7) << 3 | (*reading.code >> 6 & 3));
}

double heightOf(const CodeReading& reading) {
  const std::optional<double> height = reading.code ? modeCHeight(*reading.code) : std::nullopt;
  return height.value_or(tws::Plot::kUnknown);
}

tws_msgs::SsrPlot toSsrPlot(const SecondaryPlot& plot) {
  using tws_msgs::SsrPlot;
  const auto reading = [&](Mode mode) { return plot.readings[index(mode)]; };
  const auto bit = [&](Mode mode, int value) { return reading(mode).garbled ? value : 0; };
  SsrPlot message;
  message.stamp = tws_runtime::toTime(plot.time);
  message.range = plot.range;
  message.azimuth = plot.azimuth;
  message.height = heightOf(reading(Mode::kC));
  message.mode_1 = mode1Of(reading(Mode::k1));
  message.mode_2 = codeOf(reading(Mode::k2));
  message.mode_3a = codeOf(reading(Mode::k3A));
  message.garbled =
      static_cast<std::uint8_t>(bit(Mode::k1, SsrPlot::GARBLED_MODE_1) | bit(Mode::k2, SsrPlot::GARBLED_MODE_2) |
                                bit(Mode::k3A, SsrPlot::GARBLED_MODE_3A) | bit(Mode::kC, SsrPlot::GARBLED_MODE_C));
  message.amplitude = std::numeric_limits<float>::quiet_NaN();
  return message;
}

/// Of the parts that the reports of both kinds of radar share.
tws_msgs::SectorMark toMark(const MarkReport& report, const std::string& radar, double time, std::int64_t closed,
                            std::size_t count, const Simulation& simulation) {
  tws_msgs::SectorMark mark;
  mark.radar = radar;
  mark.header.stamp = tws_runtime::toTime(time);
  mark.header.frame_id = radar;
  mark.sector = static_cast<std::uint8_t>((closed + 1) % tws::kSectors);
  mark.running_sector = static_cast<std::uint32_t>(closed + 1);
  mark.closed_sector = static_cast<std::uint8_t>(closed % tws::kSectors);
  mark.closed_count = static_cast<std::uint32_t>(count);
  mark.running_count = static_cast<std::uint32_t>(report.plot_count);
  mark.rotation_period = report.rotation_period;
  for (const MarkReport::Beam& beam : report.others) {
    mark.other_radars.push_back(simulation.radars()[beam.radar].params().name);
    mark.other_azimuths.push_back(beam.azimuth);
  }
  return mark;
}

tws_msgs::TruthTarget toTruthTarget(const TruthReport::Entry& entry, const Target& target) {
  tws_msgs::TruthTarget message;
  message.id = static_cast<std::uint32_t>(entry.target);
  message.name = target.name;
  message.kind = toKind(target.kind);
  message.position = toXyz<geometry_msgs::Point>(entry.state.position);
  message.velocity = toXyz<geometry_msgs::Vector3>(entry.state.velocity);
  const bool is_stated = !std::isnan(target.reflection.detection_probability);
  message.rcs = is_stated ? tws::Plot::kUnknown : target.reflection.rcs;
  message.mode_3a = codeOf(target.transponder.codes[index(Mode::k3A)]);
  for (const TruthReport::Sighting& sighting : entry.sightings) {
    message.slant_range.push_back(sighting.slant_range);
    message.azimuth.push_back(sighting.azimuth);
    message.detection_probability.push_back(sighting.detection_probability);
  }
  return message;
}

}  // namespace

tws_msgs::SectorMark toSectorMark(const SectorReport& report, const Simulation& simulation) {
  return toMark(report, simulation.radars()[report.radar].params().name, report.sector.leave_time,
                report.sector.running, report.sector.plots.size(), simulation);
}

tws_msgs::SectorMark toSectorMark(const SecondarySectorReport& report, const Simulation& simulation) {
  const SectorSpan& span = report.sector.span;
  return toMark(report, simulation.secondaryRadars()[report.radar].params().name, span.leave_time, span.running,
                report.sector.plots.size(), simulation);
}

tws_msgs::SsrPlots toSsrPlots(const SecondarySector& sector, const std::string& radar) {
  tws_msgs::SsrPlots message;
  message.header.stamp = tws_runtime::toTime(sector.span.leave_time);
  message.header.frame_id = radar;
  message.radar = radar;
  message.sector = static_cast<std::uint8_t>(sector.span.running % tws::kSectors);
  message.running_sector = static_cast<std::uint32_t>(sector.span.running);
  for (const SecondaryPlot& plot : sector.plots) message.plots.push_back(toSsrPlot(plot));
  return message;
}

tws_msgs::RangeProfile toRangeProfile(const AmplitudeProfile& profile, const RangeRadarParams& radar) {
  tws_msgs::RangeProfile message;
  message.header.stamp = tws_runtime::toTime(profile.time);
  message.header.frame_id = message.radar = radar.name;
  message.profile = profile.number;
  message.range_min = profile.range_min;
  message.bin_size = radar.bin_size;
  message.azimuth = profile.azimuth;
  message.bins = static_cast<std::uint32_t>(profile.amplitude.size());
  message.amplitude = profile.amplitude;
  return message;
}

tws_msgs::Truth toTruth(const TruthReport& report, const Simulation& simulation) {
  tws_msgs::Truth truth;
  truth.header.stamp = tws_runtime::toTime(report.time);
  truth.header.frame_id = kMapFrame;
  for (const RotatingRadar& radar : simulation.radars()) truth.radars.push_back(radar.params().name);
  for (const ArrayRadar& radar : simulation.arrayRadars()) truth.radars.push_back(radar.params().name);
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
