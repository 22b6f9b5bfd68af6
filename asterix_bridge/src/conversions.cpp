#include "conversions.h"

#include <Eigen/Geometry>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>
#include <tws_core/units.h>
#include <tws_runtime/conversions.h>

namespace asterix_bridge {
namespace {

using tws_msgs::SsrPlot;

// The greatest and the least difference stand for all beyond.
bool isWithin(double difference, double unit) { return std::abs(difference) < 126.5 * unit; }

void moveToPrimary(const PlotCharacteristics& plot, tws::Plot& detection) {
  constexpr double kRangeUnit = tws::kMetresPerNauticalMile / 256.0;
  constexpr double kAzimuthUnit = tws::radians(360.0 / 16384.0);
  if (!isWithin(plot.primary_less_ssr_range, kRangeUnit) || !isWithin(plot.primary_less_ssr_azimuth, kAzimuthUnit))
    return;
  detection.range += plot.primary_less_ssr_range;
  detection.azimuth = tws::wrapTwoPi(detection.azimuth + plot.primary_less_ssr_azimuth);
}

std::uint16_t codeOf(const ModeCode& code) {
  return code.present && code.validated ? code.value : std::uint16_t{SsrPlot::CODE_UNKNOWN};
}

std::uint8_t garbledOf(const TargetReport& report) {
  return static_cast<std::uint8_t>((report.mode_1.garbled ? SsrPlot::GARBLED_MODE_1 : 0) |
                                   (report.mode_2.garbled ? SsrPlot::GARBLED_MODE_2 : 0) |
                                   (report.mode_3a.garbled ? SsrPlot::GARBLED_MODE_3A : 0) |
                                   (report.flight_level.garbled ? SsrPlot::GARBLED_MODE_C : 0));
}

SsrPlot toSsrPlot(const TimedReport& timed) {
  const TargetReport& report = timed.report;
  SsrPlot plot;
  plot.stamp = tws_runtime::toTime(timed.time);
  plot.range = report.range;
  plot.azimuth = report.azimuth;
  const bool has_height = report.flight_level.present && report.flight_level.validated;
  plot.height = has_height ? tws::metresFromFeet(100.0 * report.flight_level.level_100ft) : kUnknown;
  plot.mode_1 = codeOf(report.mode_1);
  plot.mode_2 = codeOf(report.mode_2);
  plot.mode_3a = codeOf(report.mode_3a);
  plot.aircraft_address = report.aircraft_address.value_or(0);
  plot.callsign = report.callsign.data();
  plot.garbled = garbledOf(report);
  plot.special_identification = report.special_identification;
  plot.amplitude = static_cast<float>(report.characteristics.ssr_amplitude_dbm);
  return plot;
}

template <class M>
void fillHeader(M& message, const CutSector& sector, const std::string& radar) {
  message.header.stamp = tws_runtime::toTime(sector.leave_time);
  message.header.frame_id = radar;
  message.radar = radar;
}

}  // namespace

tws::RadarSector toRadarSector(const CutSector& cut, bool primary_only) {
  tws::RadarSector sector;
  sector.sector = cut.sector;
  sector.running = cut.running;
  sector.enter_time = cut.enter_time;
  sector.leave_time = cut.leave_time;
  for (const TimedReport& timed : cut.reports) {
    if (primary_only && !timed.report.primary) continue;
    tws::Plot plot;
    plot.time = timed.time;
    plot.range = timed.report.range;
    plot.azimuth = timed.report.azimuth;
    plot.range_rate = timed.report.range_rate;
    if (primary_only) moveToPrimary(timed.report.characteristics, plot);
    if (plot.range > 0.0) sector.plots.push_back(plot);
  }
  return sector;
}

tws_msgs::SsrPlots toSsrPlots(const CutSector& sector, const std::string& radar) {
  tws_msgs::SsrPlots message;
  fillHeader(message, sector, radar);
  message.sector = static_cast<std::uint8_t>(sector.sector);
  message.running_sector = static_cast<std::uint32_t>(sector.running);
  for (const TimedReport& timed : sector.reports)
    if (timed.report.secondary) message.plots.push_back(toSsrPlot(timed));
  return message;
}

tws_msgs::SectorMark toSectorMark(const CutSector& sector, const std::string& radar, std::size_t count,
                                  std::uint32_t running_count) {
  tws_msgs::SectorMark mark;
  fillHeader(mark, sector, radar);
  mark.sector = static_cast<std::uint8_t>(tws::wrapSector(sector.sector + 1));
  mark.running_sector = static_cast<std::uint32_t>(sector.running + 1);
  mark.closed_sector = static_cast<std::uint8_t>(sector.sector);
  mark.closed_count = static_cast<std::uint32_t>(count);
  mark.running_count = running_count;
  mark.rotation_period = sector.period;
  return mark;
}

geometry_msgs::TransformStamped toTransform(const tws::LocalFrame& map, const tws::Geodetic& site,
                                            const std::string& frame, const std::string& radar) {
  geometry_msgs::TransformStamped transform = atOrigin(frame, radar);
  const Eigen::Vector3d place = map.toEnu(site);
  const tws::LocalFrame local(site);
  const Eigen::Matrix3d turn = map.ecefFromEnuRotation().transpose() * local.ecefFromEnuRotation();
  const Eigen::Quaterniond rotation = Eigen::Quaterniond(turn).normalized();
  transform.transform.translation.x = place.x();
  transform.transform.translation.y = place.y();
  transform.transform.translation.z = place.z();
  transform.transform.rotation.x = rotation.x();
  transform.transform.rotation.y = rotation.y();
  transform.transform.rotation.z = rotation.z();
  transform.transform.rotation.w = rotation.w();
  return transform;
}

geometry_msgs::TransformStamped atOrigin(const std::string& frame, const std::string& radar) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = frame;
  transform.child_frame_id = radar;
  transform.transform.rotation.w = 1.0;
  return transform;
}

}  // namespace asterix_bridge
