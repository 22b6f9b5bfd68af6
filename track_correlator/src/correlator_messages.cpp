#include "correlator_messages.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/geometry.h>
#include <tws_runtime/conversions.h>

namespace track_correlator {
namespace {

using tws_msgs::CorrelatedTrack;
using tws_msgs::Track;

/// Position and velocity at another instant, on a straight line.
void bringTo(double time, Track& track) {
  const double dt = time - tws_runtime::toSeconds(track.stamp);
  const Eigen::Vector2d velocity =
      tws::planarVelocity(track.range, track.azimuth, track.range_rate, track.azimuth_rate);
  const Eigen::Vector2d place = tws::planarFromPolar(track.range, track.azimuth) + dt * velocity;
  const tws::PolarRates rates = tws::polarRates({place.x(), place.y(), 0.0}, {velocity.x(), velocity.y(), 0.0});
  track.range = place.norm();
  track.azimuth = tws::azimuthOf(place);
  track.range_rate = rates.range;
  track.azimuth_rate = rates.azimuth;
  track.position.x += dt * track.velocity.x;
  track.position.y += dt * track.velocity.y;
  track.stamp = tws_runtime::toTime(time);
}

void takeIdentity(const Track& secondary, Track& track) {
  track.mode_1 = secondary.mode_1;
  track.mode_2 = secondary.mode_2;
  track.mode_3a = secondary.mode_3a;
  track.aircraft_address = secondary.aircraft_address;
  track.callsign = secondary.callsign;
  if (!std::isnan(secondary.height)) {
    track.height = secondary.height;
    track.height_sigma = secondary.height_sigma;
  }
  track.detection_bits |= secondary.detection_bits;
  track.first_detection = std::min(track.first_detection, secondary.first_detection);
  track.last_update = std::max(track.last_update, secondary.last_update);
  track.radars.insert(track.radars.end(), secondary.radars.begin(), secondary.radars.end());
  track.radar_updates.insert(track.radar_updates.end(), secondary.radar_updates.begin(), secondary.radar_updates.end());
}

}  // namespace

std::string faultOf(const Track& track) {
  if (!(track.range > 0.0 && track.range <= 1e7)) return "range is " + std::to_string(track.range);
  if (!(track.azimuth >= 0.0 && track.azimuth < tws::kTwoPi)) return "azimuth is " + std::to_string(track.azimuth);
  if (!std::isfinite(track.range_rate) || !std::isfinite(track.azimuth_rate)) return "a rate is no number";
  const auto& c = track.covariance;
  if (!c.empty() && c.size() != 16) return "covariance has " + std::to_string(c.size()) + " values";
  if (!std::all_of(c.begin(), c.end(), [](double v) { return std::isfinite(v); })) return "covariance is no number";
  for (std::size_t i = 0; i < c.size(); i += 5)
    if (c[i] < 0.0) return "a variance is negative";
  return "";
}

TrackInput toInput(const Track& track, double position_sigma, double velocity_sigma) {
  TrackInput input;
  input.uid = track.uid;
  input.time = tws_runtime::toSeconds(track.stamp);
  input.dropped = track.state == Track::DROPPED;
  input.state.head<2>() = tws::planarFromPolar(track.range, track.azimuth);
  input.state.tail<2>() = tws::planarVelocity(track.range, track.azimuth, track.range_rate, track.azimuth_rate);
  const double p = position_sigma * position_sigma, v = velocity_sigma * velocity_sigma;
  input.covariance = Eigen::Vector4d(p, p, v, v).asDiagonal();
  if (track.covariance.size() == 16)
    input.covariance = Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(track.covariance.data());
  return input;
}

CorrelatedTrack toMessage(const CorrelatedUpdate& update, const Track* primary, const Track* secondary, double time) {
  CorrelatedTrack message;
  message.identity = update.identity;
  message.kind = update.correlated              ? CorrelatedTrack::CORRELATED
                 : update.secondary == kNoTrack ? CorrelatedTrack::PRIMARY_ONLY
                                                : CorrelatedTrack::SECONDARY_ONLY;
  message.primary = primary != nullptr ? primary->number : CorrelatedTrack::NONE;
  message.secondary = secondary != nullptr ? secondary->number : CorrelatedTrack::NONE;
  message.scan_count = static_cast<std::uint32_t>(std::max<std::int64_t>(0, update.scan_count));
  message.fusion_count = static_cast<std::uint32_t>(update.fusion_count);
  const bool primary_leads = primary != nullptr && (primary->state != Track::DROPPED || secondary == nullptr);
  if (primary_leads || secondary != nullptr) message.track = primary_leads ? *primary : *secondary;
  bringTo(time, message.track);
  if (primary_leads && secondary != nullptr) takeIdentity(*secondary, message.track);
  if (update.coasting) message.track.state = Track::COASTING;
  if (update.ended) message.track.state = Track::DROPPED;
  message.track.number = message.track.uid = update.identity;
  return message;
}

}  // namespace track_correlator
