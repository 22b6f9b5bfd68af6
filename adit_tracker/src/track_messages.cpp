#include "track_messages.h"

#include <tws_runtime/conversions.h>

#include <cmath>
#include <limits>

#include <tws_core/angles.h>

namespace adit_tracker {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::uint8_t stateOf(const Adit& adit, const Track& track, TrackEvent event) {
  if (event == TrackEvent::kDropped) return tws_msgs::Track::DROPPED;
  if (!adit.believed(track)) return tws_msgs::Track::TENTATIVE;
  return track.coasting ? tws_msgs::Track::COASTING : tws_msgs::Track::FIRM;
}

void setPlace(tws_msgs::Track& message, const Kinematics& k, double east, double north) {
  message.stamp = tws_runtime::toTime(k.time);
  message.range = k.range;
  message.azimuth = k.azimuth;
  message.elevation = kUnknown;
  message.range_rate = k.range_rate;
  message.azimuth_rate = k.azimuth_rate;
  message.position.x = east + k.x;
  message.position.y = north + k.y;
  message.position.z = kUnknown;
  message.velocity.x = k.vx;
  message.velocity.y = k.vy;
  message.velocity.z = kUnknown;
  message.speed = std::hypot(k.vx, k.vy);
  message.course = message.speed > 0.0 ? tws::wrapTwoPi(std::atan2(k.vx, k.vy)) : kUnknown;
}

void setCovariance(tws_msgs::Track& message, const PlanarState& s) {
  message.covariance = {s.position.xx, s.position.xy, s.x_vx,        s.x_vy,         //
                        s.position.xy, s.position.yy, s.y_vx,        s.y_vy,         //
                        s.x_vx,        s.y_vx,        s.velocity.xx, s.velocity.xy,  //
                        s.x_vy,        s.y_vy,        s.velocity.xy, s.velocity.yy};
}

}  // namespace

tws_msgs::Track trackMessage(const Adit& adit, const TrackWord& word, double east, double north) {
  const Track& track = adit.tracks().at(word.slot);
  const Extrapolation now = adit.at(word.slot, word.time);
  tws_msgs::Track message;
  message.number = track.number;
  message.uid = track.uid;
  message.state = stateOf(adit, track, word.event);
  message.first_detection = tws_runtime::toTime(track.first_time);
  message.last_update = tws_runtime::toTime(track.last_update);
  setPlace(message, now.kinematics, east, north);
  if (now.has_covariance) setCovariance(message, now.planar);
  message.detection_bits = track.detected_by;
  for (std::size_t radar = 0; radar < adit.params().radars.size(); ++radar) {
    if (track.updated[radar] == kNever) continue;
    message.radars.push_back(adit.params().radars[radar].name);
    message.radar_updates.push_back(tws_runtime::toTime(track.updated[radar]));
  }
  message.mode_1 = message.mode_2 = message.mode_3a = tws_msgs::Track::CODE_UNKNOWN;
  message.height = kUnknown;
  return message;
}

tws_msgs::ClutterMap clutterMessage(const Adit& adit) {
  tws_msgs::ClutterMap message;
  for (std::size_t map = 0; map < adit.clutter().size(); ++map) {
    for (const ClutterPoint& point : adit.clutter()[map].points()) {
      tws_msgs::ClutterPoint& p = message.points.emplace_back();
      p.number = point.number;
      if (adit.params().clutter.per_radar) p.radar = adit.params().radars[map].name;
      p.last_update = tws_runtime::toTime(point.last_update);
      p.range = point.range;
      p.azimuth = point.azimuth;
      p.hits = static_cast<std::uint32_t>(point.hits);
      p.absorbing = adit.clutter()[map].absorbing(point);
    }
  }
  return message;
}

}  // namespace adit_tracker
