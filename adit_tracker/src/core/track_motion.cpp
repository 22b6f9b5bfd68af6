#include "core/track_motion.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/refraction.h>
#include "core/flat_place.h"
#include "core/rate_evidence.h"

namespace adit_tracker {
namespace {

// Hardly any manoeuvre stays hard for longer; without the limit a coasting track would take any other target's plots.
constexpr double kLongestManoeuvre = 8.0;  // [s]

double rangeOf(double x, double y) {
  return std::max(std::sqrt(x * x + y * y), 1.0);  // at the site itself rates have no meaning
}

double azimuthOf(double x, double y) { return tws::wrapTwoPi(std::atan2(x, y)); }

Kinematics fromPlanar(const tws::PlanarMotion& s, double time) {
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
tws::Symmetric2 inPolar(const tws::PlanarPosition& position, double range) {
  const double s = position.x / range, c = position.y / range;
  const tws::Symmetric2& p = position.covariance;
  return {p.xx * s * s + 2.0 * p.xy * s * c + p.yy * c * c, (p.xx - p.yy) * s * c + p.xy * (c * c - s * s),
          p.xx * c * c - 2.0 * p.xy * s * c + p.yy * s * s};
}

/// The covariance of J times what has this one.
tws::Symmetric2 mapped(const tws::Symmetric2& p, const Eigen::Matrix2d& J) {
  const double ax = J(0, 0) * p.xx + J(0, 1) * p.xy, ay = J(0, 0) * p.xy + J(0, 1) * p.yy;
  const double bx = J(1, 0) * p.xx + J(1, 1) * p.xy, by = J(1, 0) * p.xy + J(1, 1) * p.yy;
  return {J(0, 0) * ax + J(0, 1) * ay, J(1, 0) * ax + J(1, 1) * ay, J(1, 0) * bx + J(1, 1) * by};
}

/// Log-likelihood of a measurement under "it does not move", and the place improved by it.
double updatePlace(FixedPlace& place, const tws::PlanarPosition& z) {
  const tws::Symmetric2 s{place.covariance.xx + z.covariance.xx, place.covariance.xy + z.covariance.xy,
                          place.covariance.yy + z.covariance.yy};
  const double dx = z.x - place.x, dy = z.y - place.y, determinant = s.determinant();
  const double log_likelihood = -0.5 * (s.mahalanobis(dx, dy) + std::log(determinant)) - std::log(2.0 * tws::kPi);
  const tws::Symmetric2 w{s.yy / determinant, -s.xy / determinant, s.xx / determinant};
  const tws::Symmetric2 p = place.covariance;
  const double k[2][2] = {{p.xx * w.xx + p.xy * w.xy, p.xx * w.xy + p.xy * w.yy},
                          {p.xy * w.xx + p.yy * w.xy, p.xy * w.xy + p.yy * w.yy}};
  place.x += k[0][0] * dx + k[0][1] * dy;
  place.y += k[1][0] * dx + k[1][1] * dy;
  place.covariance = {p.xx - k[0][0] * p.xx - k[0][1] * p.xy, p.xy - k[0][0] * p.xy - k[0][1] * p.yy,
                      p.yy - k[1][0] * p.xy - k[1][1] * p.yy};
  return log_likelihood;
}

/// Log-likelihood of a plot under "it does not move", that of its range rate against a false plot's.
double updateStanding(FixedPlace& place, const tws::PlanarPosition& z, const tws::RangeRate& rate,
                      const RadarQuality& quality) {
  return updatePlace(place, z) + standingAgainstFalse(rate, quality);
}

/// Above the antenna [m]; NaN: the plot tells none.
double heightOf(const tws::Plot& plot) { return tws::heightOf(0.0, std::sin(plot.elevation), plot.range); }

/// Moves all that is known of a track's place.
void shift(Track& track, const tws::PlanarPosition& by) {
  std::get<tws::MultipleModelFilter>(track.filter).shift(by.x, by.y);
  track.fixed.x += by.x;
  track.fixed.y += by.y;
}

}  // namespace

TrackMotion::TrackMotion(const AditParams& params)
    : params_(params), alpha_beta_(params.alpha_beta), fast_share_(params.turning.fast_share) {}

void TrackMotion::join(const std::vector<tws::SiteFrame>& frames, const tws::EarthPlane& plane) {
  frames_ = frames;
  plane_ = plane;
  joined_ = true;
  sites_.clear();
  for (const tws::SiteFrame& frame : frames) sites_.emplace_back(plane, frame);
  auto& sites = params_.turning.sites;
  sites.clear();
  sites.reserve(frames.size());
  for (const tws::SiteFrame& frame : frames) sites.push_back({frame.x, frame.y});
  for (Volume& volume : params_.volumes) volume.params.turning.sites = sites;
}

/// Until now its slant range was laid on the plane, around the first site.
void TrackMotion::guessHeight(Track& track) const {
  const Kinematics& k = track.smoothed;
  track.height_guess = HeightGuess::below(turningOf(track).assumed_height, k.range);
  const tws::PlaceAtHeight z =
      sites_.front().placeOf(k.range, k.azimuth, 0.0, 0.0, static_cast<double>(track.height_guess.height));
  track.height_guess.begin(z);
  shift(track, {z.place.x - k.x, z.place.y - k.y, {}});
  track.smoothed = fromPlanar(std::get<tws::MultipleModelFilter>(track.filter).mean(), k.time);
}

/// A plot at the height that the track is thought to have.
tws::PlaceAtHeight TrackMotion::placeOf(const Track& track, const tws::Plot& plot, const RadarQuality& quality,
                                        std::size_t radar) const {
  return sites_[radar].placeOf(plot.range, plot.azimuth, quality.rangeSigma(plot), quality.azimuthSigma(plot),
                               static_cast<double>(track.height_guess.height));
}

/// The track as a radar sees it, dt [s] after the latest update.
tws::SiteView TrackMotion::view(const Track& track, std::size_t radar, double dt) const {
  const Kinematics& k = track.smoothed;
  return sites_[radar].view(k.x + k.vx * dt, k.y + k.vy * dt, static_cast<double>(track.height_guess.height));
}

void TrackMotion::relocate(Track& track, double x, double y) const {
  shift(track, {x - track.smoothed.x, y - track.smoothed.y, {}});
  track.smoothed = fromPlanar(std::get<tws::MultipleModelFilter>(track.filter).mean(), track.smoothed.time);
}

void TrackMotion::moveOrigin(Track& track, double dx, double dy) const {
  shift(track, {-dx, -dy, {}});
  tws::PlanarMotion motion;
  motion.x = track.smoothed.x - dx;
  motion.y = track.smoothed.y - dy;
  motion.vx = track.smoothed.vx;
  motion.vy = track.smoothed.vy;
  track.smoothed = fromPlanar(motion, track.smoothed.time);
  if (track.reference.time != kNever) adit_tracker::moveOrigin(track.reference.range, track.reference.azimuth, dx, dy);
  adit_tracker::moveOrigin(track.predicted.range, track.predicted.azimuth, dx, dy);
}

/// A range rate as the radar of that index measures it of the track.
tws::RangeRate TrackMotion::rateOf(const Track& track, double value, const RadarQuality& quality,
                                   std::size_t radar) const {
  tws::RangeRate rate = quality.rangeRate(value);
  if (!joined_) return rate;
  rate.x = frames_[radar].x;
  rate.y = frames_[radar].y;
  const double up = view(track, radar, 0.0).up, variance = static_cast<double>(track.height_guess.variance);
  rate.squared_height = up * up;
  rate.squared_height_variance = (4.0 * up * up + 2.0 * variance) * variance;
  return rate;
}

double TrackMotion::start(Track& track, const tws::Plot& plot, const RadarQuality& quality, std::size_t radar) const {
  track.first_time = track.last_update = plot.time;
  track.updates = 1;
  track.smoothed = fromPolar(plot.range, plot.azimuth, 0.0, 0.0, plot.time);
  if (params_.filter == FilterKind::kAlphaBeta) {
    track.filter = PolarFilter{alpha_beta_.start(plot.range), alpha_beta_.start(plot.azimuth)};
    return 0.0;
  }
  tws::PlanarPosition z =
      tws::planarMeasurement(plot.range, plot.azimuth, quality.rangeSigma(plot), quality.azimuthSigma(plot));
  if (joined_) {
    track.height_guess = HeightGuess::below(params_.turning.assumed_height, plot.range);
    const tws::PlaceAtHeight guessed = placeOf(track, plot, quality, radar);
    track.height_guess.begin(guessed);
    z = guessed.place;
    tws::PlanarMotion at_rest;
    at_rest.x = z.x;
    at_rest.y = z.y;
    track.smoothed = fromPlanar(at_rest, plot.time);
  }
  if (hasVolumes()) enterVolume(track, heightOf(plot));
  auto& filter = track.filter.emplace<tws::MultipleModelFilter>();
  filter.start(z, turningOf(track));
  track.fixed = {z.x, z.y, z.covariance, 0.0};
  const tws::RangeRate rate = rateOf(track, plot.range_rate, quality, radar);
  if (!rate.known()) return 0.0;
  constexpr double kLeast = -7.0;  // A thousandth: the speeds of targets are not that well known.
  const double log_ratio = std::max(kLeast, filter.correctBy(rate) + againstFalse(rate, quality));
  track.fixed.moving_evidence = log_ratio - standingAgainstFalse(rate, quality);
  track.smoothed = fromPlanar(filter.mean(), plot.time);
  return log_ratio;
}

void TrackMotion::learnSpeed(const Track& track) {
  const auto* turning = std::get_if<tws::MultipleModelFilter>(&track.filter);
  const tws::MultipleModelParams& here = turningOf(track);
  if (turning == nullptr || here.fast_speed_sigma == 0.0) return;
  constexpr double kFast = 3.0, kSure = 2.0;  // Standard deviations: of usual speeds, of this one.
  const tws::PlanarMotion now = turning->predict(0.0, here);
  const double sigma = std::sqrt(0.5 * (now.velocity.xx + now.velocity.yy));
  fast_share_.add(std::hypot(now.vx, now.vy) - kSure * sigma > kFast * here.speed_sigma);
  params_.turning.fast_share = fast_share_.value();
  for (Volume& volume : params_.volumes) volume.params.turning.fast_share = fast_share_.value();
}

void TrackMotion::branch(Track& track, const Track& parent, const Parting& parting, std::size_t radar) const {
  const Kinematics its = at(parent, track.smoothed.time).kinematics;
  Kinematics& own = track.smoothed;
  if (auto* polar = std::get_if<PolarFilter>(&track.filter)) {
    polar->range.velocity = its.range_rate + parting.rate_along;
    polar->azimuth.velocity = its.azimuth_rate + parting.rate_across / own.range;
    own = fromPolar(own.range, own.azimuth, polar->range.velocity, polar->azimuth.velocity, own.time);
    return;
  }
  if (joined_) {  // it flies as high
    shift(track, track.height_guess.moveTo(parent.height_guess.height));
    track.height_guess.variance = parent.height_guess.variance;
  }
  const double azimuth = joined_ ? frames_[radar].onPlane(parting.azimuth) : parting.azimuth;
  const double s = std::sin(azimuth), c = std::cos(azimuth);
  const double along = parting.sigma_along * parting.sigma_along, across = parting.sigma_across * parting.sigma_across;
  tws::MultipleModelFilter& filter = std::get<tws::MultipleModelFilter>(track.filter);
  filter.setVelocity(its.vx + parting.rate_along * s + parting.rate_across * c,
                     its.vy + parting.rate_along * c - parting.rate_across * s,
                     {along * s * s + across * c * c, (along - across) * s * c, along * c * c + across * s * s});
  own = fromPlanar(filter.mean(), own.time);
}

double TrackMotion::update(Track& track, const tws::Plot& plot, const RadarQuality& quality, std::size_t radar) const {
  ++track.updates;
  double log_likelihood = 0.0;
  if (params_.filter == FilterKind::kAlphaBeta) {
    updatePolar(track, plot);
  } else {
    log_likelihood = joined_ ? updateJoined(track, plot, quality, radar) : updateTurning(track, plot, quality);
  }
  track.last_update = std::max(track.last_update, plot.time);
  return log_likelihood;
}

void TrackMotion::update(Track& track, const std::vector<PlotChance>& plots, double missed, double time,
                         const RadarQuality& quality) const {
  constexpr double kNegligible = 1e-4;
  tws::MultipleModelFilter& filter = std::get<tws::MultipleModelFilter>(track.filter);
  const Kinematics& k = track.smoothed;
  const double dt = std::max(0.0, time - k.time);
  std::vector<tws::MultipleModelFilter::Weighed> measurements;
  for (const PlotChance& p : plots) {
    if (p.chance < kNegligible) {
      missed += p.chance;
      continue;
    }
    const tws::Plot& plot = p.detection->plot;
    auto z = tws::planarMeasurement(plot.range, plot.azimuth, quality.rangeSigma(plot), quality.azimuthSigma(plot));
    z.x -= (plot.time - time) * k.vx;
    z.y -= (plot.time - time) * k.vy;
    const tws::RangeRate rate = quality.rangeRate(plot.range_rate);
    measurements.push_back({z, p.chance, rate});
    if (!track.firm && p.chance > 0.5) {
      tws::MultipleModelFilter copy = filter;
      const double moving = copy.update(z, rate, dt, turningOf(track)) + againstFalse(rate, quality);
      const double standing = updateStanding(track.fixed, z, rate, quality);
      track.fixed.moving_evidence += p.chance * (moving - standing);
    }
  }
  filter.update(measurements, missed, dt, turningOf(track));
  track.smoothed = fromPlanar(filter.mean(), k.time + dt);
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
  tws::MultipleModelFilter& filter = std::get<tws::MultipleModelFilter>(track.filter);
  const double dt = std::max(0.0, plot.time - track.smoothed.time);
  const tws::PlanarPosition z =
      tws::planarMeasurement(plot.range, plot.azimuth, quality.rangeSigma(plot), quality.azimuthSigma(plot));
  const tws::RangeRate rate = quality.rangeRate(plot.range_rate);
  const double log_likelihood = filter.update(z, rate, dt, turningOf(track)) + againstFalse(rate, quality);
  if (!track.firm) track.fixed.moving_evidence += log_likelihood - updateStanding(track.fixed, z, rate, quality);
  track.smoothed = fromPlanar(filter.mean(), track.smoothed.time + dt);
  return log_likelihood;
}

/// The same, where another radar may stand elsewhere.
double TrackMotion::updateJoined(Track& track, const tws::Plot& plot, const RadarQuality& quality,
                                 std::size_t radar) const {
  tws::MultipleModelFilter& filter = std::get<tws::MultipleModelFilter>(track.filter);
  HeightGuess& guess = track.height_guess;
  const double dt = std::max(0.0, plot.time - track.smoothed.time);
  guess.age(dt, turningOf(track).assumed_height);
  shift(track, guess.flatten(plot.range, sites_[radar].height()));
  const tws::PlaceAtHeight z = placeOf(track, plot, quality, radar);
  const tws::PlanarPosition wider = guess.against(z), predicted = filter.predictPosition(dt, turningOf(track));
  const tws::RangeRate rate = rateOf(track, plot.range_rate, quality, radar);
  const double log_likelihood = filter.update(wider, rate, dt, turningOf(track)) + againstFalse(rate, quality);
  if (!track.firm) track.fixed.moving_evidence += log_likelihood - updateStanding(track.fixed, wider, rate, quality);
  shift(track, guess.learn(z, predicted, turningOf(track).assumed_height));
  track.smoothed = fromPlanar(filter.mean(), track.smoothed.time + dt);
  return log_likelihood;
}

ApparentPosition TrackMotion::apparentPosition(const Track& track, std::size_t radar, double time) const {
  const Kinematics& k = track.smoothed;
  if (!joined_) return {k.range, k.azimuth, k.azimuth_rate};
  const tws::SiteView seen = view(track, radar, time - k.time);
  // At the same height; what that does to its azimuth's rate is second to its motion on the plane.
  const double c = std::cos(frames_[radar].turn), n = std::sin(frames_[radar].turn);
  const double east_rate = c * k.vx + n * k.vy, north_rate = c * k.vy - n * k.vx;
  return {seen.range, seen.azimuth, (seen.north * east_rate - seen.east * north_rate) / (seen.ground * seen.ground)};
}

double TrackMotion::squaredDistance(const Track& track, const tws::Plot& plot, double range_sigma, double azimuth_sigma,
                                    const tws::SiteFrame& site) const {
  const double dt = plot.time - track.smoothed.time;
  tws::PlanarPosition z;
  if (joined_) {
    const tws::EarthSite there(plane_, site);
    const HeightGuess& guess = track.height_guess;
    z = guess.against(
        there.placeOf(plot.range, plot.azimuth, range_sigma, azimuth_sigma, static_cast<double>(guess.height)));
  } else {
    z = flatPlace(site, plot, range_sigma, azimuth_sigma);
  }
  tws::PlanarPosition there;
  if (const auto* turning = std::get_if<tws::MultipleModelFilter>(&track.filter)) {
    there = turning->predictPosition(dt, turningOf(track));
  } else {
    // Without a covariance the track counts as good as the plot itself.
    const Kinematics k = at(track, plot.time).kinematics;
    there = {k.x, k.y, z.covariance};
  }
  const tws::Symmetric2 S{there.covariance.xx + z.covariance.xx, there.covariance.xy + z.covariance.xy,
                          there.covariance.yy + z.covariance.yy};
  return S.mahalanobis(z.x - there.x, z.y - there.y);
}

Extrapolation TrackMotion::at(const Track& track, double time) const {
  const double dt = time - track.smoothed.time;
  if (const auto* polar = std::get_if<PolarFilter>(&track.filter)) {
    return {fromPolar(polar->range.position + polar->range.velocity * dt,
                      polar->azimuth.position + polar->azimuth.velocity * dt, polar->range.velocity,
                      polar->azimuth.velocity, time),
            false, tws::PlanarMotion{}};
  }
  const tws::PlanarMotion planar = std::get<tws::MultipleModelFilter>(track.filter).predict(dt, turningOf(track));
  Extrapolation there{fromPlanar(planar, time), true, planar};
  if (joined_) {
    Kinematics& k = there.kinematics;
    const tws::SiteView seen = sites_.front().view(k.x, k.y, static_cast<double>(track.height_guess.height));
    k.range_rate *= k.range / std::max(k.range, seen.range);
    k.range = seen.range;
    k.azimuth = seen.azimuth;
    there.planar.position = track.height_guess.widened(there.planar.position);
  }
  return there;
}

void TrackMotion::predict(Track& track, std::size_t radar, double time, const RadarQuality& quality) const {
  const double dt = time - track.smoothed.time;
  Prediction& p = track.predicted;
  p.time = time;
  p.radar = static_cast<std::uint32_t>(radar);
  if (const auto* polar = std::get_if<PolarFilter>(&track.filter)) {
    p.range = std::max(polar->range.position + polar->range.velocity * dt, 1.0);
    p.azimuth = tws::wrapTwoPi(polar->azimuth.position + polar->azimuth.velocity * dt);
    return;
  }
  const tws::PlanarPosition there =
      std::get<tws::MultipleModelFilter>(track.filter).predictPosition(dt, turningOf(track));
  if (joined_) {
    predictJoined(track, there, quality);
  } else {
    p.range = rangeOf(there.x, there.y);
    p.azimuth = azimuthOf(there.x, there.y);
    p.innovation = inPolar(there, p.range);
  }
  const double along = quality.rangeSigma() * quality.rangeSigma();
  const double cross = p.range * p.range * quality.azimuthSigma() * quality.azimuthSigma();
  p.innovation.xx += along;
  p.innovation.yy += cross;
  const double manoeuvre = tws::MultipleModelFilter::manoeuvreSigma(std::min(dt, kLongestManoeuvre), turningOf(track));
  p.manoeuvre = manoeuvre * manoeuvre;
  p.log_volume = std::log(p.innovation.determinant() / (along * cross));
  const bool blind = params_.coverage.longest_gap > 0.0 && quality.coverage().isBlind(p.range, p.azimuth);
  p.cover = blind ? kCoverWhereBlind : 1.0F;
  track.predicted_rate.variance = 0.0F;
  if (quality.measuresRates()) predictRate(track, dt, quality);
}

/// The range rate that goes with the prediction, dt [s] after the latest update.
void TrackMotion::predictRate(Track& track, double dt, const RadarQuality& quality) const {
  const tws::PlanarMotion there = std::get<tws::MultipleModelFilter>(track.filter).predict(dt, turningOf(track));
  const tws::RangeRate radar = rateOf(track, tws::Plot::kUnknown, quality, track.predicted.radar);
  const tws::RangeRatePrediction rate = tws::predictRangeRate(there, radar);
  const double variance = rate.variance + radar.sigma * radar.sigma;
  RatePrediction& p = track.predicted_rate;
  if (!tws::tellsFold(variance, radar)) return;
  const double east = there.x - radar.x, north = there.y - radar.y, ground = rangeOf(east, north);
  const double flatter = std::max(ground / track.predicted.range, 0.5);
  const double s = east / ground, c = north / ground;
  p.value = static_cast<float>(rate.value);
  p.manoeuvre = static_cast<float>(turningOf(track).manoeuvre_acceleration * std::min(dt, kLongestManoeuvre));
  // One Gaussian stands for all models: what few of them foresee is to stay within its reach.
  constexpr double kTail = 0.1;
  const double tail = kTail * static_cast<double>(p.manoeuvre);
  p.variance = static_cast<float>(variance + tail * tail);
  p.with_range = static_cast<float>((rate.to_position[0] * s + rate.to_position[1] * c) * flatter);
  p.with_cross = static_cast<float>((rate.to_position[0] * c - rate.to_position[1] * s) / flatter);
}

/// The place in the predicted radar's slant range and azimuth, with the covariance of the innovation but for the
/// radar's own errors.
void TrackMotion::predictJoined(Track& track, const tws::PlanarPosition& there, const RadarQuality& quality) const {
  Prediction& p = track.predicted;
  const HeightGuess& guess = track.height_guess;
  const tws::EarthSite& site = sites_[p.radar];
  const tws::SiteView view = site.view(there.x, there.y, static_cast<double>(guess.height));
  p.range = view.range;
  p.azimuth = view.azimuth;
  const Eigen::Vector2d by_height = site.perHeight(view);
  const tws::PlanarPosition wider = guess.against({there, by_height.x(), by_height.y(), view.up});
  const Eigen::Matrix2d on_ground = site.onGround(there.x, there.y, static_cast<double>(guess.height));
  const auto seen = [&](const tws::Symmetric2& covariance) {
    return inPolar({view.east, view.north, mapped(covariance, on_ground)}, view.ground);
  };
  const tws::Symmetric2 on_plane = seen(wider.covariance);
  const double known = seen(there.covariance).xx;
  const double flatter = std::max(view.ground / p.range, 0.5);
  p.innovation = {on_plane.xx * flatter * flatter, on_plane.xy, on_plane.yy / (flatter * flatter)};
  constexpr double kMuch = 0.1;
  p.vague_height = (on_plane.xx - known) > kMuch * quality.rangeSigma() * quality.rangeSigma();
}

}  // namespace adit_tracker
