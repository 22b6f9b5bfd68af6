#include "window_messages.h"

#include <Eigen/Geometry>
#include <algorithm>

#include <tws_runtime/track_writer.h>

namespace range_gate_tracker {
namespace {

std::uint8_t stateOf(const WindowTracker& tracker, const WindowUpdate& update) {
  if (update.event == WindowEvent::kDropped) return tws_msgs::Track::DROPPED;
  if (!tracker.isConfirmed(*update.file)) return tws_msgs::Track::TENTATIVE;
  return update.file->misses > 0 ? tws_msgs::Track::COASTING : tws_msgs::Track::FIRM;
}

/// The time of a track update: of its latest detection, or when it was last looked for.
double timeOf(const TrackFile& track) {
  return track.misses > 0 && track.previous.close >= track.previous.open ? track.previous.time : track.last_update;
}

}  // namespace

Eigen::Vector2d fromSite(double x, double y, const tws_runtime::Site& site) {
  return Eigen::Rotation2Dd(-site.turn) * Eigen::Vector2d(x - site.x, y - site.y);
}

Eigen::Vector2d toFrame(const Eigen::Vector2d& place, const tws_runtime::Site& site) {
  return Eigen::Rotation2Dd(site.turn) * place + Eigen::Vector2d(site.x, site.y);
}

tws_msgs::Track trackMessage(const WindowTracker& tracker, const WindowUpdate& update, const tws_runtime::Site& site,
                             const std::string& radar) {
  const TrackFile& track = *update.file;
  const WindowKinematics k = tracker.at(track, timeOf(track));
  tws_msgs::Track message = tws_runtime::blankTrack(track.number, track.uid);
  message.state = stateOf(tracker, update);
  message.stamp = tws_runtime::toTime(k.time);
  message.first_detection = tws_runtime::toTime(track.first_time);
  message.last_update = tws_runtime::toTime(track.last_update);
  tws_runtime::setPolar(message, {k.range, k.azimuth, k.range_rate, k.azimuth_rate});
  tws_runtime::setPlanar(message, k.position, k.velocity, site);
  if (track.misses == 0 && track.hits > 0) message.detection_bits = tws_msgs::Track::DETECTED_BY_RADAR_0;
  if (track.hits > 0) {
    message.radars.push_back(radar);
    message.radar_updates.push_back(message.last_update);
  }
  return message;
}

tws_msgs::TrackWindow windowMessage(const WindowUpdate& update) {
  const TrackFile& track = *update.file;
  const TrackWindow& window = track.window;
  tws_msgs::TrackWindow message;
  message.number = track.number;
  message.uid = track.uid;
  const std::uint8_t kind = window.tracking ? tws_msgs::TrackWindow::TRACKING : tws_msgs::TrackWindow::ACQUISITION;
  message.kind = update.event == WindowEvent::kDropped ? std::uint8_t{tws_msgs::TrackWindow::NONE} : kind;
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
