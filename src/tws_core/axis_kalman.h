#pragma once

#include <Eigen/Core>

#include <tws_core/axis_checks.h>
#include <tws_core/axis_motion.h>

namespace tws {

/// One coordinate of one track in an AxisKalman: position, velocity and, for N = 3, acceleration.
template <int N>
struct AxisKalmanState {
  Eigen::Matrix<double, N, 1> mean = Eigen::Matrix<double, N, 1>::Zero();
  Eigen::Matrix<double, N, N> covariance = Eigen::Matrix<double, N, N>::Zero();
};

/// The Kalman filter of one coordinate for constant velocity (N = 2) or constant acceleration (N = 3). The target's
/// acceleration (N = 3: the step that it takes at the start of each interval) is white from interval to interval, with
/// the standard deviation noise.acceleration: the model of Kalata's tracking index, so that at even intervals the gains
/// settle at steadyGains(N - 1, Λ). Two half intervals are therefore noisier than a whole one. (kalman.h has the filter
/// of a whole plane, with correlated coordinates and noise in continuous time.)
template <int N>
class AxisKalman {
  static_assert(N == 2 || N == 3, "constant velocity or constant acceleration");

 public:
  using State = AxisKalmanState<N>;
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;

  State start(double position, const AxisNoise& noise) const {
    State state;
    state.mean[0] = position;
    const Vector sigma = Vector(Eigen::Vector3d(noise.measurement, noise.velocity, noise.acceleration).head<N>());
    state.covariance.diagonal() = sigma.cwiseAbs2();
    return state;
  }

  static AxisMotion motion(const State& state) {
    if constexpr (N == 3) return {state.mean[0], state.mean[1], state.mean[2]};
    return {state.mean[0], state.mean[1], 0.0};
  }

  /// As FixedGainFilter::update(); noise.measurement > 0.
  void update(State& state, double innovation, double dt, const AxisNoise& noise) const {
    requireUpdate(innovation, dt);
    if (dt == 0.0) return;
    predict(state, dt, noise.acceleration);
    const double variance = noise.measurement * noise.measurement;
    const Vector gain = state.covariance.col(0) / (state.covariance(0, 0) + variance);
    state.mean += gain * innovation;
    // Joseph's form: a sum of squares, so that the covariance stays one when measurements are very precise.
    Matrix keep = Matrix::Identity();
    keep.col(0) -= gain;
    state.covariance = (keep * state.covariance * keep.transpose() + variance * gain * gain.transpose()).eval();
  }

 private:
  static void predict(State& state, double dt, double acceleration_sigma) {
    Matrix transition = Matrix::Identity();
    Vector kick;
    const double half = 0.5 * dt * dt;
    if constexpr (N == 3) {
      transition(0, 1) = transition(1, 2) = dt;
      transition(0, 2) = half;
      kick << half, dt, 1.0;
    } else {
      transition(0, 1) = dt;
      kick << half, dt;
    }
    kick *= acceleration_sigma;
    state.mean = (transition * state.mean).eval();
    state.covariance = (transition * state.covariance * transition.transpose() + kick * kick.transpose()).eval();
  }
};

}  // namespace tws
