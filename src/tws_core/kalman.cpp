#include <tws_core/kalman.h>

#include <cmath>

#include <tws_core/geometry.h>

namespace tws {
namespace {

// Covariance with the given variances along and across the line of sight.
Eigen::Matrix2d rotated(double along, double across, double azimuth) {
  const double sine = std::sin(azimuth), cosine = std::cos(azimuth);
  const double off = (along - across) * sine * cosine;
  Eigen::Matrix2d covariance;
  covariance << along * sine * sine + across * cosine * cosine, off, off,
      along * cosine * cosine + across * sine * sine;
  return covariance;
}

Eigen::Matrix2d symmetric(const Eigen::Matrix2d& matrix) { return 0.5 * (matrix + matrix.transpose()); }

void assemble(Eigen::Matrix4d& covariance, const Eigen::Matrix2d& position, const Eigen::Matrix2d& cross,
              const Eigen::Matrix2d& velocity) {
  covariance.topLeftCorner<2, 2>() = position;
  covariance.topRightCorner<2, 2>() = cross;
  covariance.bottomLeftCorner<2, 2>() = cross.transpose();
  covariance.bottomRightCorner<2, 2>() = velocity;
}

}  // namespace

PlanarMeasurement convertedMeasurement(double range, double azimuth, double sigma_range, double sigma_azimuth) {
  const double across = range * sigma_azimuth;
  return {planarFromPolar(range, azimuth), rotated(sigma_range * sigma_range, across * across, azimuth)};
}

PlanarMeasurement unbiasedMeasurement(double range, double azimuth, double sigma_range, double sigma_azimuth) {
  const double azimuth_variance = sigma_azimuth * sigma_azimuth;
  const double range_variance = sigma_range * sigma_range;
  // Exact moments of (r + w_r)·(cos w_a, sin w_a)/E[cos w_a], with E[cos w_a] = exp(-σ²/2) and E[cos 2w_a] = exp(-2σ²).
  const double half_sinh = std::sinh(0.5 * azimuth_variance);
  const double along = range_variance * std::cosh(azimuth_variance) + 2.0 * range * range * half_sinh * half_sinh;
  const double across = (range * range + range_variance) * std::sinh(azimuth_variance);
  return {planarFromPolar(range * std::exp(0.5 * azimuth_variance), azimuth), rotated(along, across, azimuth)};
}

PlanarState startState(const PlanarMeasurement& measurement, double sigma_velocity) {
  PlanarState state;
  state.mean.head<2>() = measurement.position;
  state.covariance.topLeftCorner<2, 2>() = measurement.covariance;
  state.covariance.diagonal().tail<2>().setConstant(sigma_velocity * sigma_velocity);
  return state;
}

void predict(PlanarState& state, double dt, double q) {
  state.mean.head<2>() += dt * state.mean.tail<2>();
  const Eigen::Matrix2d velocity = state.covariance.bottomRightCorner<2, 2>();
  const Eigen::Matrix2d cross = state.covariance.topRightCorner<2, 2>();
  const Eigen::Matrix2d moved_cross = cross + dt * velocity;
  // P_pp + dt·(P_pv + P_vp) + dt²·P_vv, each term symmetric by itself.
  Eigen::Matrix2d position =
      state.covariance.topLeftCorner<2, 2>() + dt * (cross + cross.transpose()) + dt * dt * velocity;
  position.diagonal().array() += q * dt * dt * dt / 3.0;
  const Eigen::Matrix2d identity = Eigen::Matrix2d::Identity();
  assemble(state.covariance, position, moved_cross + 0.5 * q * dt * dt * identity, velocity + q * dt * identity);
}

PlanarInnovation innovation(const PlanarState& predicted, const PlanarMeasurement& measurement) {
  PlanarInnovation result;
  result.residual = measurement.position - predicted.mean.head<2>();
  result.covariance = predicted.covariance.topLeftCorner<2, 2>() + measurement.covariance;
  const Eigen::Matrix2d& s = result.covariance;
  const double determinant = s(0, 0) * s(1, 1) - s(0, 1) * s(1, 0);
  result.inverse << s(1, 1), -s(0, 1), -s(1, 0), s(0, 0);
  result.inverse /= determinant;
  result.nis = result.residual.dot(result.inverse * result.residual);
  return result;
}

void update(PlanarState& state, const PlanarMeasurement& measurement, const PlanarInnovation& innovation) {
  const Eigen::Matrix2d position = state.covariance.topLeftCorner<2, 2>();
  const Eigen::Matrix2d cross = state.covariance.topRightCorner<2, 2>();
  const Eigen::Matrix2d velocity_gain = cross.transpose() * innovation.inverse;
  state.mean.head<2>() += position * (innovation.inverse * innovation.residual);
  state.mean.tail<2>() += velocity_gain * innovation.residual;
  // (I - K)·P_pp = R·S⁻¹·P_pp: a product, so that a precise measurement is not the difference of two large numbers.
  const Eigen::Matrix2d keep = measurement.covariance * innovation.inverse;
  const Eigen::Matrix2d velocity = state.covariance.bottomRightCorner<2, 2>() - velocity_gain * cross;
  assemble(state.covariance, symmetric(keep * position), keep * cross, symmetric(velocity));
}

}  // namespace tws
