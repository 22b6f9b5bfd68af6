#include "track_feed_messages.h"

#include <cmath>
#include <optional>

#include <tws_core/geometry.h>
#include <tws_core/sectors.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/track_writer.h>

#include "conversions.h"

namespace radar_sim {
namespace {

using tws_msgs::Track;

std::uint16_t codeOf(const Transponder& transponder, Mode mode) {
  const int code = transponder.codes[index(mode)];
  return code >= 0 ? static_cast<std::uint16_t>(code) : std::uint16_t{Track::CODE_UNKNOWN};
}

/// The pulses of mode 1 as the number of its two octal digits.
std::uint16_t mode1Of(const Transponder& transponder) {
  const std::uint16_t code = codeOf(transponder, Mode::k1);
  if (code == Track::CODE_UNKNOWN) return code;
  return static_cast<std::uint16_t>((code >> 9 & 7) << 3 | (code >> 6 & 3));
}

/// How far up a track is, relative to its radar [m]; nothing: its height is not known, or not within its range.
std::optional<double> upOf(const FedTrack& track, double range, const Eigen::Isometry3d& radar_to_map,
                           const tws::SeaLevel& sea) {
  const Eigen::Vector3d from = radar_to_map.translation();
  const Eigen::Vector2d direction =
      (radar_to_map.linear() * Eigen::Vector3d(track.state(0), track.state(1), 0.0)).head<2>().normalized();
  const std::optional<double> z = sea.upAtRange(from, direction, range, track.height);
  if (!z) return std::nullopt;
  return *z - from.z();
}

/// Without a height the slant range is laid on the ground.
void setCartesian(const FedTrack& track, const Eigen::Isometry3d& radar_to_map, const tws::SeaLevel& sea,
                  Track& message) {
  const std::optional<double> up = upOf(track, message.range, radar_to_map, sea);
  const double ground = tws::groundRange(message.range, up.value_or(0.0));
  const double part = message.range > 0.0 ? ground / message.range : 1.0;
  const Eigen::Vector3d place = radar_to_map * Eigen::Vector3d(part * track.state(0), part * track.state(1), 0.0);
  const Eigen::Vector3d velocity = radar_to_map.linear() * Eigen::Vector3d(track.state(2), track.state(3), 0.0);
  message.position.x = place.x();
  message.position.y = place.y();
  message.position.z = up ? radar_to_map.translation().z() + *up : tws::Plot::kUnknown;
  message.velocity.x = velocity.x();
  message.velocity.y = velocity.y();
  message.velocity.z = tws::Plot::kUnknown;
  message.speed = velocity.head<2>().norm();
  message.course = message.speed > 0.0 ? tws::azimuthOf(velocity.head<2>()) : tws::Plot::kUnknown;
}

void setCovariance(const TrackFeedParams& params, Track& message) {
  message.covariance.assign(16, 0.0);
  for (std::size_t i = 0; i < 4; ++i) {
    const double sigma = i < 2 ? params.position_sigma : params.velocity_sigma;
    message.covariance[5 * i] = sigma * sigma;
  }
}

void setIdentity(const Target& target, const FedTrack& track, Track& message) {
  message.mode_1 = mode1Of(target.transponder);
  message.mode_2 = codeOf(target.transponder, Mode::k2);
  message.mode_3a = codeOf(target.transponder, Mode::k3A);
  if (target.transponder.altitude) message.height = track.height;
}

Track toTrack(const TrackFeed& feed, const FedTrack& track, const Target& target, const Eigen::Isometry3d& radar_to_map,
              const tws::SeaLevel& sea) {
  const bool primary = feed.kind() == FeedKind::kPrimary;
  Track message = tws_runtime::blankTrack(track.number, track.number);
  message.state = track.dropped ? Track::DROPPED : Track::FIRM;
  message.stamp = message.last_update = tws_runtime::toTime(track.time);
  message.first_detection = tws_runtime::toTime(track.first_time);
  const Eigen::Vector2d place = track.state.head<2>(), velocity = track.state.tail<2>();
  const tws::PolarRates rates = tws::polarRates({place.x(), place.y(), 0.0}, {velocity.x(), velocity.y(), 0.0});
  tws_runtime::setPolar(message, {place.norm(), tws::azimuthOf(place), rates.range, rates.azimuth});
  setCartesian(track, radar_to_map, sea, message);
  setCovariance(feed.params(), message);
  message.detection_bits = primary ? Track::DETECTED_BY_RADAR_0 : Track::DETECTED_BY_IFF;
  message.radars = {feed.params().clock_radar};
  message.radar_updates = {message.last_update};
  if (!primary) setIdentity(target, track, message);
  return message;
}

}  // namespace

std::string nameOf(FeedKind kind) { return kind == FeedKind::kPrimary ? "primary" : "secondary"; }

tws_msgs::Tracks toTracks(const TrackFeed& feed, const std::vector<FedTrack>& tracks, const tws::RadarSector& sector,
                          const std::vector<Target>& targets, const tws::SeaLevel& sea) {
  const Eigen::Isometry3d radar_to_map = feed.mapToRadar().inverse();
  tws_msgs::Tracks message;
  message.header.stamp = tws_runtime::toTime(sector.enter_time);
  message.header.frame_id = kMapFrame;
  message.tracker = nameOf(feed.kind());
  message.radar = feed.params().clock_radar;
  message.sector = static_cast<std::uint8_t>(sector.sector);
  message.running_sector = static_cast<std::uint32_t>(sector.running);
  for (const FedTrack& track : tracks)
    message.tracks.push_back(toTrack(feed, track, targets[track.target], radar_to_map, sea));
  return message;
}

}  // namespace radar_sim
