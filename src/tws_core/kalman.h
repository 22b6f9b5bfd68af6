#pragma once

#include <Eigen/Core>

namespace tws {

/// State of the constant-velocity Kalman filter in N dimensions (1 to 3): position [m], then velocity [m/s] along the
/// same axes; x east, y north, z up where they are those of the map.
template <int N>
struct MotionState {
  using Vector = Eigen::Matrix<double, 2 * N, 1>;
  using Matrix = Eigen::Matrix<double, 2 * N, 2 * N>;
  Vector mean = Vector::Zero();
  Matrix covariance = Matrix::Zero();  // kept exactly symmetric
};

/// A measured position.
template <int N>
struct PositionMeasurement {
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;
  Vector position = Vector::Zero();    // [m]
  Matrix covariance = Matrix::Zero();  // R [m²]
};

/// What a measurement says about a predicted state.
template <int N>
struct Innovation {
  Eigen::Matrix<double, N, 1> residual;    // measured minus predicted [m]
  Eigen::Matrix<double, N, N> covariance;  // S = H·P·Hᵀ + R [m²]
  Eigen::Matrix<double, N, N> inverse;     // S⁻¹
  double nis = 0.0;                        // normalised innovation squared, χ² with N degrees of freedom
};

using LinearState = MotionState<1>;
using LinearMeasurement = PositionMeasurement<1>;
using LinearInnovation = Innovation<1>;
using PlanarState = MotionState<2>;
using PlanarMeasurement = PositionMeasurement<2>;
using PlanarInnovation = Innovation<2>;
using SpatialState = MotionState<3>;
using SpatialMeasurement = PositionMeasurement<3>;
using SpatialInnovation = Innovation<3>;

/// A radar's range [m] and azimuth [rad] as a position with the covariance of the linearised conversion; sigmas > 0.
/// Good while range·sigma_azimuth² is well below sigma_range, else the position is biased inwards.
PlanarMeasurement convertedMeasurement(double range, double azimuth, double sigma_range, double sigma_azimuth);

/// The unbiased conversion (Mo, Song, Zhou, Sun and Bar-Shalom, "Unbiased converted measurements for tracking", IEEE
/// Trans. AES 34-3, 1998): divided by E[cos(azimuth error)] = exp(-σ²/2), with the exact covariance for a target at the
/// measured place.
PlanarMeasurement unbiasedMeasurement(double range, double azimuth, double sigma_range, double sigma_azimuth);

// What follows is there for N = 1, 2 and 3.

/// A track's first state: at the measurement, velocity 0 with this standard deviation in each axis [m/s].
template <int N>
MotionState<N> startState(const PositionMeasurement<N>& measurement, double sigma_velocity);

/// Moves the state on by dt [s] under white acceleration of spectral density q [m²/s³] in each axis. dt ≥ 0; a negative
/// dt with q = 0 retrodicts the mean.
template <int N>
void predict(MotionState<N>& state, double dt, double q);

template <int N>
Innovation<N> innovation(const MotionState<N>& predicted, const PositionMeasurement<N>& measurement);

/// Takes the measurement in. The innovation must be the one of this state and measurement. The covariance stays
/// symmetric, and positive definite also when the measurement is far more precise than the prediction.
template <int N>
void update(MotionState<N>& state, const PositionMeasurement<N>& measurement, const Innovation<N>& innovation);

}  // namespace tws
