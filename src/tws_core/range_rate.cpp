#include <tws_core/range_rate.h>

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace tws {
namespace {

/// What is known before the rate is looked at.
MeasurementFit fitOf(const RangeRatePrediction& p, double variance, const RangeRate& z) {
  if (!tellsFold(variance, z)) return {0.0, 1.0 / z.ambiguity};
  const double innovation = z.difference(z.value, p.value);
  return {innovation * innovation / variance, 1.0 / std::sqrt(kTwoPi * variance)};
}

/// Of the product of two errors across the line of sight: that of the direction and that of the velocity.
double productVariance(const PlanarMotion& s, double c, double n, double range) {
  const double position = c * c * s.position.xx - 2.0 * c * n * s.position.xy + n * n * s.position.yy;
  const double velocity = c * c * s.velocity.xx - 2.0 * c * n * s.velocity.xy + n * n * s.velocity.yy;
  const double both = c * c * s.x_vx - c * n * (s.x_vy + s.y_vx) + n * n * s.y_vy;
  return (position * velocity + both * both) / (range * range);
}

}  // namespace

RangeRatePrediction predictRangeRate(const PlanarMotion& s, const RangeRate& radar) {
  constexpr double kNearest = 1.0;  // [m]: at the radar itself rates have no meaning
  const double east = s.x - radar.x, north = s.y - radar.y, ground2 = east * east + north * north;
  const double range = std::max(kNearest, std::sqrt(ground2 + radar.squared_height));
  RangeRatePrediction p{};
  p.value = (east * s.vx + north * s.vy) / range;
  p.vx = east / range;
  p.vy = north / range;
  p.x = (s.vx - p.value * p.vx) / range;
  p.y = (s.vy - p.value * p.vy) / range;
  p.to_position[0] = s.position.xx * p.x + s.position.xy * p.y + s.x_vx * p.vx + s.x_vy * p.vy;
  p.to_position[1] = s.position.xy * p.x + s.position.yy * p.y + s.y_vx * p.vx + s.y_vy * p.vy;
  p.to_velocity[0] = s.x_vx * p.x + s.y_vx * p.y + s.velocity.xx * p.vx + s.velocity.xy * p.vy;
  p.to_velocity[1] = s.x_vy * p.x + s.y_vy * p.y + s.velocity.xy * p.vx + s.velocity.yy * p.vy;
  const double by_height = 0.5 * p.value / (range * range);
  const double ground = std::max(kNearest, std::sqrt(ground2));
  p.variance = p.x * p.to_position[0] + p.y * p.to_position[1] + p.vx * p.to_velocity[0] + p.vy * p.to_velocity[1] +
               productVariance(s, north / ground, east / ground, range) +
               by_height * by_height * radar.squared_height_variance;
  return p;
}

MeasurementFit fitOf(const PlanarMotion& s, const RangeRate& z) {
  const RangeRatePrediction p = predictRangeRate(s, z);
  return fitOf(p, p.variance + z.sigma * z.sigma, z);
}

MeasurementFit correct(TurningMotion& s, const RangeRate& z) {
  const RangeRatePrediction p = predictRangeRate(s, z);
  const double variance = p.variance + z.sigma * z.sigma;
  const MeasurementFit fit = fitOf(p, variance, z);
  if (!tellsFold(variance, z)) return fit;
  const double weight = 1.0 / variance, gain = z.difference(z.value, p.value) * weight;
  const double x = p.to_position[0], y = p.to_position[1], vx = p.to_velocity[0], vy = p.to_velocity[1];
  if (s.rate_variance > 0.0) {
    const double rate = s.x_rate * p.x + s.y_rate * p.y + s.vx_rate * p.vx + s.vy_rate * p.vy;
    s.rate += gain * rate;
    s.rate_variance -= weight * rate * rate;
    s.x_rate -= weight * rate * x;
    s.y_rate -= weight * rate * y;
    s.vx_rate -= weight * rate * vx;
    s.vy_rate -= weight * rate * vy;
  }
  s.x += gain * x;
  s.y += gain * y;
  s.vx += gain * vx;
  s.vy += gain * vy;
  s.position.xx -= weight * x * x;
  s.position.xy -= weight * x * y;
  s.position.yy -= weight * y * y;
  s.x_vx -= weight * x * vx;
  s.x_vy -= weight * x * vy;
  s.y_vx -= weight * y * vx;
  s.y_vy -= weight * y * vy;
  s.velocity.xx -= weight * vx * vx;
  s.velocity.xy -= weight * vx * vy;
  s.velocity.yy -= weight * vy * vy;
  return fit;
}

}  // namespace tws
