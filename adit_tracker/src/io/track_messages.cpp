#include "io/track_messages.h"

#include <tws_runtime/conversions.h>
#include <tws_runtime/track_writer.h>

#include <cmath>
#include <limits>

#include <tws_core/angles.h>

#include "elevation/track_height.h"

namespace adit_tracker {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::uint8_t stateOf(const Adit& adit, const Track& track, TrackEvent event) {
  if (event == TrackEvent::kDropped) return tws_msgs::Track::DROPPED;
  if (!adit.tracks().confirmed(track)) return tws_msgs::Track::TENTATIVE;
  return track.coasting ? tws_msgs::Track::COASTING : tws_msgs::Track::FIRM;
}

void setPlace(tws_msgs::Track& message, const Kinematics& k, const Site& site) {
  const double c = std::cos(site.turn), s = std::sin(site.turn);
  message.stamp = tws_runtime::toTime(k.time);
  message.range = k.range;
  message.azimuth = k.azimuth;
  message.range_rate = k.range_rate;
  message.azimuth_rate = k.azimuth_rate;
  message.position.x = site.x + c * k.x - s * k.y;
  message.position.y = site.y + s * k.x + c * k.y;
  message.velocity.x = c * k.vx - s * k.vy;
  message.velocity.y = s * k.vx + c * k.vy;
  message.speed = std::hypot(k.vx, k.vy);
  message.course = message.speed > 0.0 ? tws::wrapTwoPi(std::atan2(k.vx, k.vy)) : kUnknown;
}

void setCovariance(tws_msgs::Track& message, const tws::PlanarMotion& p, const Site& site) {
  const double c = std::cos(site.turn), s = std::sin(site.turn);
  const double own[4][4] = {{p.position.xx, p.position.xy, p.x_vx, p.x_vy},
                            {p.position.xy, p.position.yy, p.y_vx, p.y_vy},
                            {p.x_vx, p.y_vx, p.velocity.xx, p.velocity.xy},
                            {p.x_vy, p.y_vy, p.velocity.xy, p.velocity.yy}};
  const double turn[4][4] = {{c, -s, 0.0, 0.0}, {s, c, 0.0, 0.0}, {0.0, 0.0, c, -s}, {0.0, 0.0, s, c}};
  message.covariance.assign(16, 0.0);
  for (std::size_t cell = 0; cell < 16; ++cell) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) message.covariance[cell] += turn[cell / 4][i] * own[i][j] * turn[cell % 4][j];
    }
  }
}

void setOutputs(tws_msgs::Track& message, const Adit& adit, const Track& track) {
  if (adit.params().life == TrackLife::kExistence) message.existence = track.existence;
  if (const auto* turning = std::get_if<tws::MultipleModelFilter>(&track.filter)) {
    const auto& [straight, left, right, free] = turning->probabilities();
    message.model_probabilities = {static_cast<float>(straight), static_cast<float>(right), static_cast<float>(left),
                                   static_cast<float>(free)};
  }
}

static_assert(int{PlotFate::kLeft} == int{tws_msgs::PlotFate::LEFT} &&
              int{PlotFate::kUpdated} == int{tws_msgs::PlotFate::UPDATED} &&
              int{PlotFate::kStarted} == int{tws_msgs::PlotFate::STARTED} &&
              int{PlotFate::kClutter} == int{tws_msgs::PlotFate::CLUTTER} &&
              int{PlotFate::kSkipped} == int{tws_msgs::PlotFate::SKIPPED});

tws_msgs::PlotFate fateMessage(const PlotFate& fate) {
  tws_msgs::PlotFate message;
  message.stamp = tws_runtime::toTime(fate.plot.time);
  message.range = fate.plot.range;
  message.azimuth = fate.plot.azimuth;
  message.fate = static_cast<std::uint8_t>(fate.kind);
  message.track = fate.uid;
  message.chance_false = static_cast<float>(fate.left);
  for (const PlotClaim& claim : fate.claims) {
    tws_msgs::PlotClaim& c = message.claims.emplace_back();
    c.track = claim.uid;
    c.chance = claim.chance;
    c.sigmas = claim.sigmas;
  }
  return message;
}

}  // namespace

tws_msgs::PlotFates fatesMessage(const Adit& adit, const SectorFates& sector) {
  tws_msgs::PlotFates message;
  const double entered = adit.radars().antenna(sector.radar).timeAt(tws::Antenna::startOf(sector.running));
  message.header.stamp = tws_runtime::toTime(entered);
  message.radar = adit.params().radars[sector.radar].name;
  message.sector = static_cast<std::uint8_t>(tws::Antenna::sectorNumber(sector.running));
  message.running_sector = static_cast<std::uint32_t>(sector.running);
  for (const PlotFate& fate : sector.plots) message.plots.push_back(fateMessage(fate));
  return message;
}

Site originOf(const Adit& adit, const Site& site) {
  const double c = std::cos(site.turn), s = std::sin(site.turn);
  Site origin = site;
  origin.x += c * adit.origin().x - s * adit.origin().y;
  origin.y += s * adit.origin().x + c * adit.origin().y;
  return origin;
}

tws_msgs::Track trackMessage(const Adit& adit, const TrackUpdate& update, const Site& first_site) {
  const Site site = originOf(adit, first_site);
  const Track& track = adit.tracks().at(update.slot);
  const Extrapolation now = adit.tracks().extrapolate(update.slot, update.time);
  tws_msgs::Track message = tws_runtime::blankTrack(track.number, track.uid);
  message.state = stateOf(adit, track, update.event);
  message.first_detection = tws_runtime::toTime(track.first_time);
  message.last_update = tws_runtime::toTime(track.last_update);
  setPlace(message, now.kinematics, site);
  const auto guess = static_cast<double>(track.height_guess.height);
  if (track.height_guess.known())
    message.position.z = site.z + adit.radars().plane().zAt(now.kinematics.x, now.kinematics.y, guess);
  if (now.has_covariance) setCovariance(message, now.planar, site);
  message.detection_bits = track.detected_by;
  if (track.answers_iff != 0) message.detection_bits |= tws_msgs::Track::DETECTED_BY_IFF;
  if (track.handed_off) message.detection_bits |= tws_msgs::Track::HANDED_OFF;
  if (track.designated) message.detection_bits |= tws_msgs::Track::ELEVATION_REQUESTED;
  for (std::size_t radar = 0; radar < adit.params().radars.size(); ++radar) {
    if (track.updated[radar] == kNever) continue;
    message.radars.push_back(adit.params().radars[radar].name);
    message.radar_updates.push_back(tws_runtime::toTime(track.updated[radar]));
  }
  setOutputs(message, adit, track);
  message.plot_range = update.plot_range;
  message.plot_azimuth = update.plot_azimuth;
  if (const auto height = adit.tracks().height(update.slot, update.time))
    setHeight(message, *height, site, !adit.radars().severalSites());
  if (adit.params().map) tws_runtime::setGeodetic(message, *adit.params().map, guess);
  return message;
}

tws_msgs::ClutterMap clutterMessage(const Adit& adit) {
  tws_msgs::ClutterMap message;
  for (std::size_t map = 0; map < adit.clutter().maps().size(); ++map) {
    for (const ClutterPoint& point : adit.clutter().maps()[map].points()) {
      tws_msgs::ClutterPoint& p = message.points.emplace_back();
      p.number = point.number;
      if (adit.params().clutter.per_radar) p.radar = adit.params().radars[map].name;
      p.last_update = tws_runtime::toTime(point.last_update);
      p.range = point.range;
      p.azimuth = point.azimuth;
      if (const auto& pose = adit.radars().at(map).pose)
        asMeasured(adit.origin(), {0.0, 0.0, *pose, *pose}, 0.0, p.range, p.azimuth);
      p.hits = static_cast<std::uint32_t>(point.hits);
      p.absorbing = adit.clutter().maps()[map].absorbing(point);
    }
  }
  return message;
}

}  // namespace adit_tracker
