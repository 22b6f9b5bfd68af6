#pragma once

#include <cmath>

namespace tws {

/// A symmetric 2 × 2 matrix.
struct Symmetric2 {
  double xx = 0.0, xy = 0.0, yy = 0.0;

  double determinant() const { return xx * yy - xy * xy; }
  /// v' M⁻¹ v
  double mahalanobis(double x, double y) const { return (yy * x * x - 2.0 * xy * x * y + xx * y * y) / determinant(); }
};

/// Gaussian of a position on the plane (x east, y north [m], covariance [m²]): a measurement, or a prediction of one.
struct PlanarPosition {
  double x = 0.0, y = 0.0;
  Symmetric2 covariance;
};

/// A measurement by range [m] and azimuth [rad] with their standard deviations, on the plane. First-order conversion;
/// good while range · azimuth_sigma² / 2 is small against the sigmas (below 0.1 of them to 400 km at 0.3°).
inline PlanarPosition planarMeasurement(double range, double azimuth, double range_sigma, double azimuth_sigma) {
  const double s = std::sin(azimuth), c = std::cos(azimuth);
  const double along = range_sigma * range_sigma, cross = range * range * azimuth_sigma * azimuth_sigma;
  return {
      range * s, range * c, {along * s * s + cross * c * c, (along - cross) * s * c, along * c * c + cross * s * s}};
}

/// Gaussian of position and velocity on the plane. The covariance is kept as blocks: position, cross (row: position,
/// column: velocity), velocity.
struct PlanarMotion {
  double x = 0.0, y = 0.0, vx = 0.0, vy = 0.0;  // [m], [m/s]
  Symmetric2 position;
  double x_vx = 0.0, x_vy = 0.0, y_vx = 0.0, y_vy = 0.0;
  Symmetric2 velocity;
};

}  // namespace tws
