#include <tws_runtime/conversions.h>

#include <tws_core/angles.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace tws_runtime {
namespace {

constexpr double kHalfPi = tws::kPi / 2.0;
constexpr double kLargest = std::numeric_limits<double>::max();
constexpr double kSmallest = std::numeric_limits<double>::denorm_min();

/// Where a number may lie; what may be unknown may be NaN.
struct Field {
  const char* name;
  double value;
  double least;
  double greatest;
  bool may_be_unknown;
};

bool isGood(const Field& field) {
  if (std::isnan(field.value)) return field.may_be_unknown;
  return field.value >= field.least && field.value <= field.greatest;
}

}  // namespace

double toSeconds(ros::Time time) {
  return static_cast<double>(static_cast<long double>(time.toNSec()) / 1e9L);  // A double cannot hold all of toNSec().
}

double secondsBetween(ros::Time earlier, ros::Time later) { return toSeconds(later) - toSeconds(earlier); }

ros::Time toTime(double seconds) {
  constexpr double kEnd = 4294967296.0;  // 2^32, the end of ros::Time.
  if (!(seconds >= 0.0 && seconds < kEnd))
    throw std::invalid_argument("no data time: " + std::to_string(seconds) + " s");
  const double whole = std::floor(seconds);
  const auto nanoseconds = static_cast<std::uint64_t>(std::llround((seconds - whole) * 1e9));
  ros::Time time;
  time.fromNSec(static_cast<std::uint64_t>(whole) * 1000000000u + nanoseconds);
  return time;
}

std::optional<Site> findSite(const tf2::BufferCore& transforms, const std::string& frame,
                             const std::string& radar_frame, std::string& why) {
  if (!transforms.canTransform(frame, radar_frame, ros::Time(0), &why)) return std::nullopt;
  const auto transform = transforms.lookupTransform(frame, radar_frame, ros::Time(0)).transform;
  const auto& q = transform.rotation;
  const auto& at = transform.translation;
  return Site{at.x, at.y, at.z, std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z))};
}

std::string faultOf(const tws_msgs::Detection& detection) {
  const double below_two_pi = std::nextafter(tws::kTwoPi, 0.0);
  const Field fields[] = {
      {"range", detection.range, kSmallest, kLargest, false},
      {"azimuth", detection.azimuth, 0.0, below_two_pi, false},
      {"elevation", detection.elevation, -kHalfPi, kHalfPi, true},
      {"range rate", detection.range_rate, -kLargest, kLargest, true},
      {"range sigma", detection.range_sigma, 0.0, kLargest, true},
      {"azimuth sigma", detection.azimuth_sigma, 0.0, kLargest, true},
      {"elevation sigma", detection.elevation_sigma, 0.0, kLargest, true},
      {"signal-to-noise ratio", detection.snr, -kLargest, kLargest, true},
  };
  for (const Field& field : fields) {
    if (isGood(field)) continue;
    std::ostringstream fault;
    fault << field.name << " is " << field.value;
    return fault.str();
  }
  return "";
}

std::string faultOf(const tws_msgs::SsrPlot& plot, double leave_time) {
  const double time = toSeconds(plot.stamp);
  if (!(plot.range > 0.0 && plot.range <= 1e7)) return "range is " + std::to_string(plot.range);
  if (!(plot.azimuth >= 0.0 && plot.azimuth < tws::kTwoPi)) return "azimuth is " + std::to_string(plot.azimuth);
  // A sector lasts two seconds at most.
  if (!(std::abs(time - leave_time) <= 2.0)) return "stamp is " + std::to_string(time) + ", outside of its sector";
  return "";
}

tws::Plot toPlot(const tws_msgs::Detection& detection) {
  tws::Plot plot;
  plot.time = toSeconds(detection.stamp);
  plot.range = detection.range;
  plot.azimuth = detection.azimuth;
  plot.elevation = detection.elevation;
  plot.range_rate = detection.range_rate;
  plot.range_sigma = detection.range_sigma;
  plot.azimuth_sigma = detection.azimuth_sigma;
  plot.elevation_sigma = detection.elevation_sigma;
  plot.snr = static_cast<double>(detection.snr);
  return plot;
}

tws_msgs::Detection toDetection(const tws::Plot& plot) {
  tws_msgs::Detection detection;
  detection.stamp = toTime(plot.time);
  detection.range = plot.range;
  detection.azimuth = plot.azimuth;
  detection.elevation = plot.elevation;
  detection.range_rate = plot.range_rate;
  detection.range_sigma = plot.range_sigma;
  detection.azimuth_sigma = plot.azimuth_sigma;
  detection.elevation_sigma = plot.elevation_sigma;
  detection.snr = static_cast<float>(plot.snr);
  return detection;
}

tws_msgs::Detections toDetections(const tws::RadarSector& sector, const std::string& radar, const std::string& frame) {
  tws_msgs::Detections message;
  message.header.stamp = toTime(sector.leave_time);
  message.header.frame_id = frame;
  message.radar = radar;
  message.sector = static_cast<std::uint8_t>(sector.sector);
  message.running_sector = static_cast<std::uint32_t>(sector.running);
  for (const tws::Plot& plot : sector.plots) message.detections.push_back(toDetection(plot));
  return message;
}

}  // namespace tws_runtime
