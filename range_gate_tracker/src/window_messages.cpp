#include "window_messages.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include <tws_core/geometry.h>

namespace range_gate_tracker {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::uint8_t stateOf(const WindowTracker& tracker, const WindowWord& word) {
  if (word.event == WindowEvent::kDropped) return tws_msgs::Track::DROPPED;
  if (!tracker.believed(*word.file)) return tws_msgs::Track::TENTATIVE;
  return word.file->misses > 0 ? tws_msgs::Track::COASTING : tws_msgs::Track::FIRM;
}

/// The time for which a track is told: of its latest detection, or when it was last looked for.
double timeOf(const TrackFile& track) {
  return track.misses > 0 && track.previous.close >= track.previous.open ? track.previous.time : track.last_update;
}

void setPlace(tws_msgs::Track& message, const WindowKinematics& k, const tws_runtime::Site& site) {
  const Eigen::Vector2d position = toFrame(k.position, site);
  const Eigen::Vector2d velocity = Eigen::Rotation2Dd(site.turn) * k.velocity;
  message.stamp = tws_runtime::toTime(k.time);
  message.range = k.range;
  message.azimuth = k.azimuth;
  message.elevation = kUnknown;
  message.range_rate = k.range_rate;
  message.azimuth_rate = k.azimuth_rate;
  message.position.x = position.x();
  message.position.y = position.y();
  message.velocity.x = velocity.x();
  message.velocity.y = velocity.y();
  message.position.z = message.velocity.z = kUnknown;
  message.speed = velocity.norm();
  message.course = message.speed > 0.0 ? tws::azimuthOf(velocity) : kUnknown;
}

}  // namespace

Eigen::Vector2d fromSite(double x, double y, const tws_runtime::Site& site) {
  return Eigen::Rotation2Dd(-site.turn) * Eigen::Vector2d(x - site.x, y - site.y);
}

Eigen::Vector2d toFrame(const Eigen::Vector2d& place, const tws_runtime::Site& site) {
  return Eigen::Rotation2Dd(site.turn) * place + Eigen::Vector2d(site.x, site.y);
}

tws_msgs::Track trackMessage(const WindowTracker& tracker, const WindowWord& word, const tws_runtime::Site& site,
                             const std::string& radar) {
  const TrackFile& track = *word.file;
  tws_msgs::Track message;
  message.number = track.number;
  message.uid = track.uid;
  message.state = stateOf(tracker, word);
  message.first_detection = tws_runtime::toTime(track.first_time);
  message.last_update = tws_runtime::toTime(track.last_update);
  setPlace(message, tracker.at(track, timeOf(track)), site);
  if (track.misses == 0 && track.hits > 0) message.detection_bits = tws_msgs::Track::DETECTED_BY_RADAR_0;
  if (track.hits > 0) {
    message.radars.push_back(radar);
    message.radar_updates.push_back(message.last_update);
  }
  message.mode_1 = message.mode_2 = message.mode_3a = tws_msgs::Track::CODE_UNKNOWN;
  message.height = message.height_sigma = kUnknown;
  return message;
}

tws_msgs::TrackWindow windowMessage(const WindowWord& word) {
  const TrackFile& track = *word.file;
  const TrackWindow& window = track.window;
  tws_msgs::TrackWindow message;
  message.number = track.number;
  message.uid = track.uid;
  const std::uint8_t kind = window.tracking ? tws_msgs::TrackWindow::TRACKING : tws_msgs::TrackWindow::ACQUISITION;
  message.kind = word.event == WindowEvent::kDropped ? std::uint8_t{tws_msgs::TrackWindow::NONE} : kind;
  message.designated = track.designated;
  message.type = static_cast<std::uint8_t>(track.type);
  message.priority = static_cast<std::uint8_t>(track.priority);
  message.hits = static_cast<std::uint16_t>(std::min(track.hits, 65535));
  message.misses = static_cast<std::uint16_t>(std::min(track.misses, 65535));
  message.expected = tws_runtime::toTime(window.time);
  message.range = window.range;
  message.azimuth = window.azimuth;
  message.half_range = window.half_range;
  message.half_azimuth = window.half_azimuth;
  message.measured = tws_runtime::toTime(track.measured.time);
  message.measured_range = track.measured.range;
  message.measured_azimuth = track.measured.azimuth;
  return message;
}

}  // namespace range_gate_tracker
