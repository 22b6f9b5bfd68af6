#pragma once

#include <Eigen/Core>

namespace tws {

/// State of the planar constant-velocity Kalman filter: x, y [m], vx, vy [m/s], x east and y north.
struct PlanarState {
  Eigen::Vector4d mean = Eigen::Vector4d::Zero();
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  // kept exactly symmetric
};

/// A measured position.
struct PlanarMeasurement {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();    // [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // R [m²]
};

/// What a measurement says about a predicted state.
struct PlanarInnovation {
  Eigen::Vector2d residual;    // measured minus predicted [m]
  Eigen::Matrix2d covariance;  // S = H·P·Hᵀ + R [m²]
  Eigen::Matrix2d inverse;     // S⁻¹
  double nis = 0.0;            // normalised innovation squared, χ² with two degrees of freedom
};

/// A radar's range [m] and azimuth [rad] as a position with the covariance of the linearised conversion; sigmas > 0.
/// Good while range·sigma_azimuth² is well below sigma_range, else the position is biased inwards.
PlanarMeasurement convertedMeasurement(double range, double azimuth, double sigma_range, double sigma_azimuth);

/// The unbiased conversion (Mo, Song, Zhou, Sun and Bar-Shalom, "Unbiased converted measurements for tracking", IEEE
/// Trans. AES 34-3, 1998): divided by E[cos(azimuth error)] = exp(-σ²/2), with the exact covariance for a target at the
/// measured place.
PlanarMeasurement unbiasedMeasurement(double range, double azimuth, double sigma_range, double sigma_azimuth);

/// A track's first state: at the measurement, velocity 0 with this standard deviation in each axis [m/s].
PlanarState startState(const PlanarMeasurement& measurement, double sigma_velocity);

/// Moves the state on by dt [s] under white acceleration of spectral density q [m²/s³] in each axis. dt ≥ 0; a negative
/// dt with q = 0 retrodicts the mean.
void predict(PlanarState& state, double dt, double q);

PlanarInnovation innovation(const PlanarState& predicted, const PlanarMeasurement& measurement);

/// Takes the measurement in. The innovation must be the one of this state and measurement. The covariance stays
/// symmetric, and positive definite also when the measurement is far more precise than the prediction.
void update(PlanarState& state, const PlanarMeasurement& measurement, const PlanarInnovation& innovation);

}  // namespace tws
