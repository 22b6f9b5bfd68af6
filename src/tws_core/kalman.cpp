#include <tws_core/kalman.h>

#include <Eigen/LU>
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

template <int N>
using Square = Eigen::Matrix<double, N, N>;

template <int N>
Square<N> symmetric(const Square<N>& matrix) {
  return 0.5 * (matrix + matrix.transpose());
}

template <int N>
void assemble(Square<2 * N>& covariance, const Square<N>& position, const Square<N>& cross, const Square<N>& velocity) {
  covariance.template topLeftCorner<N, N>() = position;
  covariance.template topRightCorner<N, N>() = cross;
  covariance.template bottomLeftCorner<N, N>() = cross.transpose();
  covariance.template bottomRightCorner<N, N>() = velocity;
}

Square<1> inverseOf(const Square<1>& s) { return s.cwiseInverse(); }

Square<2> inverseOf(const Square<2>& s) {
  Square<2> inverse;
  inverse << s(1, 1), -s(0, 1), -s(1, 0), s(0, 0);
  return inverse / (s(0, 0) * s(1, 1) - s(0, 1) * s(1, 0));
}

Square<3> inverseOf(const Square<3>& s) { return symmetric<3>(s.inverse()); }

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

template <int N>
MotionState<N> startState(const PositionMeasurement<N>& measurement, double sigma_velocity) {
  MotionState<N> state;
  state.mean.template head<N>() = measurement.position;
  state.covariance.template topLeftCorner<N, N>() = measurement.covariance;
  state.covariance.diagonal().template tail<N>().setConstant(sigma_velocity * sigma_velocity);
  return state;
}

template <int N>
void predict(MotionState<N>& state, double dt, double q) {
  state.mean.template head<N>() += dt * state.mean.template tail<N>();
  const Square<N> velocity = state.covariance.template bottomRightCorner<N, N>();
  const Square<N> cross = state.covariance.template topRightCorner<N, N>();
  const Square<N> moved_cross = cross + dt * velocity;
  // P_pp + dt·(P_pv + P_vp) + dt²·P_vv, each term symmetric by itself.
  Square<N> position =
      state.covariance.template topLeftCorner<N, N>() + dt * (cross + cross.transpose()) + dt * dt * velocity;
  position.diagonal().array() += q * dt * dt * dt / 3.0;
  const Square<N> identity = Square<N>::Identity();
  assemble<N>(state.covariance, position, moved_cross + 0.5 * q * dt * dt * identity, velocity + q * dt * identity);
}

template <int N>
Innovation<N> innovation(const MotionState<N>& predicted, const PositionMeasurement<N>& measurement) {
  Innovation<N> result;
  result.residual = measurement.position - predicted.mean.template head<N>();
  result.covariance = predicted.covariance.template topLeftCorner<N, N>() + measurement.covariance;
  result.inverse = inverseOf(result.covariance);
  result.nis = result.residual.dot(result.inverse * result.residual);
  return result;
}

template <int N>
void update(MotionState<N>& state, const PositionMeasurement<N>& measurement, const Innovation<N>& innovation) {
  const Square<N> position = state.covariance.template topLeftCorner<N, N>();
  const Square<N> cross = state.covariance.template topRightCorner<N, N>();
  const Square<N> velocity_gain = cross.transpose() * innovation.inverse;
  state.mean.template head<N>() += position * (innovation.inverse * innovation.residual);
  state.mean.template tail<N>() += velocity_gain * innovation.residual;
  // (I - K)·P_pp = R·S⁻¹·P_pp: a product, so that a precise measurement is not the difference of two large numbers.
  const Square<N> keep = measurement.covariance * innovation.inverse;
  const Square<N> velocity = state.covariance.template bottomRightCorner<N, N>() - velocity_gain * cross;
  assemble<N>(state.covariance, symmetric<N>(keep * position), keep * cross, symmetric<N>(velocity));
}

template LinearState startState(const LinearMeasurement&, double);
template void predict(LinearState&, double, double);
template LinearInnovation innovation(const LinearState&, const LinearMeasurement&);
template void update(LinearState&, const LinearMeasurement&, const LinearInnovation&);
template PlanarState startState(const PlanarMeasurement&, double);
template void predict(PlanarState&, double, double);
template PlanarInnovation innovation(const PlanarState&, const PlanarMeasurement&);
template void update(PlanarState&, const PlanarMeasurement&, const PlanarInnovation&);
template SpatialState startState(const SpatialMeasurement&, double);
template void predict(SpatialState&, double, double);
template SpatialInnovation innovation(const SpatialState&, const SpatialMeasurement&);
template void update(SpatialState&, const SpatialMeasurement&, const SpatialInnovation&);

}  // namespace tws
