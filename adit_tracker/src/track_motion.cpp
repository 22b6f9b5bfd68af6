#include "track_motion.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace adit_tracker {
namespace {

double rangeOf(double x, double y) {
  return std::max(std::sqrt(x * x + y * y), 1.0);  // at the site itself rates have no meaning
}

double azimuthOf(double x, double y) { return tws::wrapTwoPi(std::atan2(x, y)); }

Kinematics fromPlanar(const PlanarState& s, double time) {
  Kinematics k;
  k.time = time;
  k.x = s.x;
  k.y = s.y;
  k.vx = s.vx;
  k.vy = s.vy;
  k.range = rangeOf(s.x, s.y);
  k.azimuth = azimuthOf(s.x, s.y);
  k.range_rate = (s.x * s.vx + s.y * s.vy) / k.range;
  k.azimuth_rate = (s.y * s.vx - s.x * s.vy) / (k.range * k.range);
  return k;
}

Kinematics fromPolar(double range, double azimuth, double range_rate, double azimuth_rate, double time) {
  Kinematics k;
  k.time = time;
  k.range = std::max(range, 1.0);
  k.azimuth = tws::wrapTwoPi(azimuth);
  k.range_rate = range_rate;
  k.azimuth_rate = azimuth_rate;
  const double s = std::sin(k.azimuth), c = std::cos(k.azimuth);
  k.x = k.range * s;
  k.y = k.range * c;
  k.vx = range_rate * s + k.range * azimuth_rate * c;
  k.vy = range_rate * c - k.range * azimuth_rate * s;
  return k;
}

/// The covariance of a position in range and cross-range, as seen from the origin.
Symmetric2 inPolar(const PlanarPosition& position, double range) {
  const double s = position.x / range, c = position.y / range;
  const Symmetric2& p = position.covariance;
  return {p.xx * s * s + 2.0 * p.xy * s * c + p.yy * c * c, (p.xx - p.yy) * s * c + p.xy * (c * c - s * s),
          p.xx * c * c - 2.0 * p.xy * s * c + p.yy * s * s};
}

/// Log-likelihood of a measurement under "it does not move", and the place improved by it.
double updatePlace(FixedPlace& place, const PlanarPosition& z) {
  const Symmetric2 s{place.covariance.xx + z.covariance.xx, place.covariance.xy + z.covariance.xy,
                     place.covariance.yy + z.covariance.yy};
  const double dx = z.x - place.x, dy = z.y - place.y, determinant = s.determinant();
  const double log_likelihood = -0.5 * (s.mahalanobis(dx, dy) + std::log(determinant)) - std::log(2.0 * tws::kPi);
  const Symmetric2 w{s.yy / determinant, -s.xy / determinant, s.xx / determinant};
  const Symmetric2 p = place.covariance;
  const double k[2][2] = {{p.xx * w.xx + p.xy * w.xy, p.xx * w.xy + p.xy * w.yy},
                          {p.xy * w.xx + p.yy * w.xy, p.xy * w.xy + p.yy * w.yy}};
  place.x += k[0][0] * dx + k[0][1] * dy;
  place.y += k[1][0] * dx + k[1][1] * dy;
  place.covariance = {p.xx - k[0][0] * p.xx - k[0][1] * p.xy, p.xy - k[0][0] * p.xy - k[0][1] * p.yy,
                      p.yy - k[1][0] * p.xy - k[1][1] * p.yy};
  return log_likelihood;
}

}  // namespace

TrackMotion::TrackMotion(const AditParams& params) : params_(params), alpha_beta_(params.alpha_beta) {}

void TrackMotion::start(Track& track, const tws::Plot& plot, const RadarQuality& quality) const {
  track.first_time = track.last_update = plot.time;
  track.updates = 1;
  track.smoothed = fromPolar(plot.range, plot.azimuth, 0.0, 0.0, plot.time);
  if (params_.filter == FilterKind::kAlphaBeta) {
    track.filter = PolarFilter{alpha_beta_.start(plot.range), alpha_beta_.start(plot.azimuth)};
    return;
  }
  const PlanarPosition z =
      planarMeasurement(plot.range, plot.azimuth, quality.rangeSigma(plot), quality.azimuthSigma(plot));
  track.filter.emplace<TurningFilter>().start(z, params_.turning);
  track.fixed = {z.x, z.y, z.covariance, 0.0};
}

double TrackMotion::update(Track& track, const tws::Plot& plot, const RadarQuality& quality) const {
  ++track.updates;
  double log_likelihood = 0.0;
  if (params_.filter == FilterKind::kAlphaBeta) {
    updatePolar(track, plot);
  } else {
    log_likelihood = updateTurning(track, plot, quality);
  }
  track.last_update = std::max(track.last_update, plot.time);
  return log_likelihood;
}

void TrackMotion::updatePolar(Track& track, const tws::Plot& plot) const {
  PolarFilter& filter = std::get<PolarFilter>(track.filter);
  // Near a crossing of two beams the order of plots can be inverted; the second one then has T1 = 0 and no weight.
  const double T1 = std::max(0.0, plot.time - track.smoothed.time);
  alpha_beta_.update(filter.range, plot.range - tws::AdaptiveAlphaBeta::predict(filter.range, T1), T1);
  const double azimuth_error =
      tws::angularDifference(plot.azimuth, tws::AdaptiveAlphaBeta::predict(filter.azimuth, T1));
  alpha_beta_.update(filter.azimuth, azimuth_error, T1);
  filter.azimuth.position = tws::wrapTwoPi(filter.azimuth.position);
  track.smoothed = fromPolar(filter.range.position, filter.azimuth.position, filter.range.velocity,
                             filter.azimuth.velocity, track.smoothed.time + T1);
}

double TrackMotion::updateTurning(Track& track, const tws::Plot& plot, const RadarQuality& quality) const {
  TurningFilter& filter = std::get<TurningFilter>(track.filter);
  const double dt = std::max(0.0, plot.time - track.smoothed.time);
  const PlanarPosition z =
      planarMeasurement(plot.range, plot.azimuth, quality.rangeSigma(plot), quality.azimuthSigma(plot));
  const double log_likelihood = filter.update(z, dt, params_.turning);
  if (!track.firm) track.fixed.moving_evidence += log_likelihood - updatePlace(track.fixed, z);
  track.smoothed = fromPlanar(filter.mean(), track.smoothed.time + dt);
  return log_likelihood;
}

Extrapolation TrackMotion::at(const Track& track, double time) const {
  const double dt = time - track.smoothed.time;
  if (const auto* polar = std::get_if<PolarFilter>(&track.filter)) {
    return {fromPolar(polar->range.position + polar->range.velocity * dt,
                      polar->azimuth.position + polar->azimuth.velocity * dt, polar->range.velocity,
                      polar->azimuth.velocity, time),
            false, PlanarState{}};
  }
  const PlanarState planar = std::get<TurningFilter>(track.filter).predict(dt, params_.turning);
  return {fromPlanar(planar, time), true, planar};
}

void TrackMotion::predict(Track& track, std::size_t radar, double time, const RadarQuality& quality) const {
  const double dt = time - track.smoothed.time;
  Prediction& p = track.predicted;
  p.time = time;
  p.radar = radar;
  if (const auto* polar = std::get_if<PolarFilter>(&track.filter)) {
    p.range = std::max(polar->range.position + polar->range.velocity * dt, 1.0);
    p.azimuth = tws::wrapTwoPi(polar->azimuth.position + polar->azimuth.velocity * dt);
    return;
  }
  const PlanarPosition there = std::get<TurningFilter>(track.filter).predictPosition(dt, params_.turning);
  p.range = rangeOf(there.x, there.y);
  p.azimuth = azimuthOf(there.x, there.y);
  const double along = quality.rangeSigma() * quality.rangeSigma();
  const double cross = p.range * p.range * quality.azimuthSigma() * quality.azimuthSigma();
  p.innovation = inPolar(there, p.range);
  p.innovation.xx += along;
  p.innovation.yy += cross;
  // Hardly any manoeuvre stays hard for longer; without the limit a coasting track would take any other target's plots.
  constexpr double kLongestManoeuvre = 8.0;  // [s]
  const double manoeuvre = TurningFilter::manoeuvreSigma(std::min(dt, kLongestManoeuvre), params_.turning);
  p.manoeuvre = manoeuvre * manoeuvre;
  p.log_volume = std::log(p.innovation.determinant() / (along * cross));
}

}  // namespace adit_tracker
