#include <tws_core/geometry.h>

#include <cmath>

#include <tws_core/angles.h>

namespace tws {

Eigen::Vector3d enuFromPolar(const Polar& polar) {
  const double ground = polar.range * std::cos(polar.elevation);
  return {ground * std::sin(polar.azimuth), ground * std::cos(polar.azimuth), polar.range * std::sin(polar.elevation)};
}

Polar polarFromEnu(const Eigen::Vector3d& enu) {
  const double ground = std::hypot(enu.x(), enu.y());
  return {std::hypot(ground, enu.z()), wrapTwoPi(std::atan2(enu.x(), enu.y())), std::atan2(enu.z(), ground)};
}

Eigen::Vector3d enuVelocity(const Polar& polar, const PolarRates& rates) {
  const double sin_azimuth = std::sin(polar.azimuth), cos_azimuth = std::cos(polar.azimuth);
  const double sin_elevation = std::sin(polar.elevation), cos_elevation = std::cos(polar.elevation);
  const double outward = rates.range * cos_elevation - polar.range * sin_elevation * rates.elevation;
  const double across = polar.range * cos_elevation * rates.azimuth;
  const double up = rates.range * sin_elevation + polar.range * cos_elevation * rates.elevation;
  return {outward * sin_azimuth + across * cos_azimuth, outward * cos_azimuth - across * sin_azimuth, up};
}

PolarRates polarRates(const Eigen::Vector3d& enu, const Eigen::Vector3d& velocity) {
  const double range = enu.norm();
  if (range == 0.0) return {velocity.norm(), 0.0, 0.0};
  const double ground = std::hypot(enu.x(), enu.y());
  const double range_rate = enu.dot(velocity) / range;
  if (ground == 0.0) return {range_rate, 0.0, 0.0};
  const double ground_rate = (enu.x() * velocity.x() + enu.y() * velocity.y()) / ground;
  const double azimuth_rate = (velocity.x() * enu.y() - velocity.y() * enu.x()) / (ground * ground);
  return {range_rate, azimuth_rate, (velocity.z() * ground - enu.z() * ground_rate) / (range * range)};
}

double groundRange(double slant_range, double height) {
  const double level = std::abs(height);
  return slant_range <= level ? 0.0 : std::sqrt((slant_range - level) * (slant_range + level));
}

double slantRange(double ground_range, double height) { return std::hypot(ground_range, height); }

Eigen::Vector2d planarFromPolar(double range, double azimuth) {
  return {range * std::sin(azimuth), range * std::cos(azimuth)};
}

Eigen::Vector2d planarVelocity(double range, double azimuth, double range_rate, double azimuth_rate) {
  const double sine = std::sin(azimuth), cosine = std::cos(azimuth), across = range * azimuth_rate;
  return {range_rate * sine + across * cosine, range_rate * cosine - across * sine};
}

double azimuthOf(const Eigen::Vector2d& planar) { return wrapTwoPi(std::atan2(planar.x(), planar.y())); }

}  // namespace tws
