#include "range_gate_messages.h"

#include <cmath>
#include <limits>

#include <tws_core/angles.h>
#include <tws_core/geometry.h>
#include <tws_runtime/track_writer.h>

namespace range_gate_tracker {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::uint8_t lockOf(Lock lock) {
  switch (lock) {
    case Lock::kLocked:
      return tws_msgs::RangeGate::LOCKED;
    case Lock::kCoasting:
      return tws_msgs::RangeGate::COASTING;
    case Lock::kSearching:
      break;
  }
  return tws_msgs::RangeGate::SEARCHING;
}

}  // namespace

std::string faultOf(const tws_msgs::RangeProfile& message) {
  if (message.amplitude.size() != message.bins)
    return std::to_string(message.amplitude.size()) + " amplitudes, announced: " + std::to_string(message.bins);
  if (std::isinf(message.azimuth)) return "azimuth is infinite";
  return "";
}

RangeProfile toProfile(const tws_msgs::RangeProfile& message) {
  return {tws_runtime::toSeconds(message.header.stamp), message.range_min, message.bin_size, message.amplitude};
}

tws_msgs::RangeGate toMessage(const GateReport& report, const RangeGateParams& params) {
  tws_msgs::RangeGate message;
  message.header.stamp = tws_runtime::toTime(report.time);
  message.lock = lockOf(report.lock);
  message.range_min = report.gate.min;
  message.range_max = report.gate.max;
  message.measured_range = report.measured;
  message.smoothed_range = report.smoothed;
  message.predicted_range = report.predicted;
  message.prediction_time = params.prediction_time;
  message.range_rate = report.rate;
  message.power = report.power;
  message.quality = report.quality;
  message.window = params.window;
  message.threshold = params.threshold;
  return message;
}

tws_msgs::Track toTrack(const GateReport& report, double azimuth, std::uint32_t uid) {
  tws_msgs::Track track = tws_runtime::blankTrack(1, uid);
  track.stamp = tws_runtime::toTime(report.time);
  track.state = report.lock == Lock::kLocked ? tws_msgs::Track::FIRM : tws_msgs::Track::COASTING;
  tws_runtime::setPolar(
      track, {report.smoothed, std::isnan(azimuth) ? kUnknown : tws::wrapTwoPi(azimuth), report.rate, kUnknown});
  track.detection_bits =
      report.lock == Lock::kLocked ? std::uint16_t{tws_msgs::Track::DETECTED_BY_RADAR_0} : std::uint16_t{0};
  return track;
}

void place(tws_msgs::Track& track, const tws_runtime::Site& site) {
  const double direction = track.azimuth - site.turn;
  const auto at = tws::planarFromPolar(track.range, direction);
  const auto velocity = tws::planarFromPolar(track.range_rate, direction);
  track.position.x = site.x + at.x();
  track.position.y = site.y + at.y();
  track.velocity.x = velocity.x();
  track.velocity.y = velocity.y();
  track.speed = std::abs(track.range_rate);
  track.course = track.speed > 0.0 ? tws::azimuthOf(velocity) : kUnknown;
}

}  // namespace range_gate_tracker
