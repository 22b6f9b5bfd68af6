#pragma once

#include <Eigen/Dense>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/multiple_model_filter.h>

namespace tws {

using Vector4 = Eigen::Vector4d;
using Matrix4 = Eigen::Matrix4d;
using Matrix24 = Eigen::Matrix<double, 2, 4>;

inline Matrix4 denseOf(const PlanarMotion& s) {
  Matrix4 p;
  p << s.position.xx, s.position.xy, s.x_vx, s.x_vy,  //
      s.position.xy, s.position.yy, s.y_vx, s.y_vy,   //
      s.x_vx, s.y_vx, s.velocity.xx, s.velocity.xy,   //
      s.x_vy, s.y_vy, s.velocity.xy, s.velocity.yy;
  return p;
}

inline Vector4 meanOf(const PlanarMotion& s) { return {s.x, s.y, s.vx, s.vy}; }

inline Eigen::Matrix2d denseOf(const Symmetric2& m) { return (Eigen::Matrix2d() << m.xx, m.xy, m.xy, m.yy).finished(); }

/// exp(A dt) of motion with a turn rate, anticlockwise positive, by its series.
inline Matrix4 transition(double dt, double turn_rate) {
  Matrix4 a = Matrix4::Zero();
  a(0, 2) = a(1, 3) = 1.0;
  a(2, 3) = -turn_rate;
  a(3, 2) = turn_rate;
  Matrix4 sum = Matrix4::Identity(), term = sum;
  for (int n = 1; n < 40; ++n) sum += term = term * a * dt / n;
  return sum;
}

inline Matrix4 whiteAcceleration(double dt, double q) {
  Matrix4 m = Matrix4::Zero();
  for (int i = 0; i < 2; ++i) {
    m(i, i) = q * dt * dt * dt / 3.0;
    m(i, i + 2) = m(i + 2, i) = q * dt * dt / 2.0;
    m(i + 2, i + 2) = q * dt;
  }
  return m;
}

/// Neither slant range nor hard manoeuvres, targets that are all alike: what the textbook has.
inline MultipleModelParams textbook() {
  MultipleModelParams params;
  params.assumed_height = 0.0;
  params.manoeuvre_acceleration = 0.0;
  params.fast_speed_sigma = 0.0;
  return params;
}

/// The same with turns that all have one rate, and no motion besides.
inline MultipleModelParams fixedRates() {
  MultipleModelParams params = textbook();
  params.turn_rate_sigma = 0.0;
  params.free_share = 0.0;
  params.straight_acceleration = 0.2;
  params.turning_acceleration = 15.0;
  params.straight_time = 100.0;
  return params;
}

inline double gaussian(double squared, double determinant) {
  return std::exp(-0.5 * squared) / (2.0 * kPi * std::sqrt(determinant));
}

using Vector5 = Eigen::Matrix<double, 5, 1>;
using Matrix5 = Eigen::Matrix<double, 5, 5>;
using Matrix25 = Eigen::Matrix<double, 2, 5>;

/// State and turn rate dt later.
inline Vector5 moved(const Vector5& x, double dt) {
  Vector5 y = x;
  y.head<4>() = transition(dt, x[4]) * x.head<4>();
  return y;
}

/// The rate at which the slant range grows, of a target in that state.
inline double rangeRate(const Vector5& x, const RangeRate& radar) {
  const Eigen::Vector2d place(x[0] - radar.x, x[1] - radar.y);
  return place.dot(x.segment<2>(2)) / std::sqrt(place.squaredNorm() + radar.squared_height);
}

/// An extended Kalman filter's update, whose derivatives are differences. Returns the likelihood.
inline double correctDensely(Vector5& x, Matrix5& p, const RangeRate& z) {
  Vector5 h;
  const double steps[5] = {0.1, 0.1, 1e-3, 1e-3, 1e-5};
  for (int k = 0; k < 5; ++k) {
    const Vector5 step = Vector5::Unit(k) * steps[k];
    h[k] = (rangeRate(x + step, z) - rangeRate(x - step, z)) / (2.0 * steps[k]);
  }
  const Eigen::Vector2d place(x[0] - z.x, x[1] - z.y), across(place.y() / place.norm(), -place.x() / place.norm());
  const double slant2 = place.squaredNorm() + z.squared_height;
  const double of_both = across.dot(p.block<2, 2>(0, 2) * across);
  const double products = across.dot(p.block<2, 2>(0, 0) * across) * across.dot(p.block<2, 2>(2, 2) * across);
  const double by_height = rangeRate(x, z) / (2.0 * slant2);
  const double s = h.dot(p * h) + (products + of_both * of_both) / slant2 +
                   by_height * by_height * z.squared_height_variance + z.sigma * z.sigma;
  const double innovation = z.value - rangeRate(x, z);
  const Vector5 k = p * h / s;
  x += k * innovation;
  p -= k * (h.transpose() * p).eval();
  return std::exp(-0.5 * innovation * innovation / s) / std::sqrt(2.0 * kPi * s);
}

/// Interacting multiple models as in Bar-Shalom, Li & Kirubarajan, "Estimation with Applications to Tracking and
/// Navigation", section 11.6.6, with dense matrices; the turn rate is the fifth state of an extended Kalman filter
/// whose derivatives are differences.
struct DenseImm {
  static constexpr int kModels = 4;
  MultipleModelParams params = textbook();
  Vector5 x[kModels];
  Matrix5 p[kModels];
  double mu[kModels];

  double rate(int i) const { return i == 1 ? params.turn_rate : (i == 2 ? -params.turn_rate : 0.0); }
  double rateSigma(int i) const { return i == 1 || i == 2 ? params.turn_rate_sigma : 0.0; }

  void forgetRate(Vector5& state, Matrix5& covariance, int model) const {
    state[4] = rate(model);
    covariance.row(4).setZero();
    covariance.col(4).setZero();
    covariance(4, 4) = rateSigma(model) * rateSigma(model);
  }

  void start(const PlanarPosition& z) {
    const double manoeuvring = params.turning_time / (params.straight_time + params.turning_time);
    const double share[kModels] = {0.0, 0.5 * (1.0 - params.free_share), 0.5 * (1.0 - params.free_share),
                                   params.free_share};
    for (int i = 0; i < kModels; ++i) {
      x[i] << z.x, z.y, 0.0, 0.0, 0.0;
      p[i] = Matrix5::Zero();
      p[i].topLeftCorner<2, 2>() = denseOf(z.covariance);
      p[i].block<2, 2>(2, 2) = Eigen::Matrix2d::Identity() * params.speed_sigma * params.speed_sigma;
      forgetRate(x[i], p[i], i);
      mu[i] = i == 0 ? 1.0 - manoeuvring : manoeuvring * share[i];
    }
  }

  void move(int i, double dt) {
    const double densities[kModels] = {params.straight_acceleration, params.turning_acceleration,
                                       params.turning_acceleration, params.free_acceleration};
    Matrix5 f;
    const double steps[5] = {1.0, 1.0, 1e-2, 1e-2, 1e-5};
    for (int k = 0; k < 5; ++k) {
      const Vector5 step = Vector5::Unit(k) * steps[k];
      f.col(k) = (moved(x[i] + step, dt) - moved(x[i] - step, dt)) / (2.0 * steps[k]);
    }
    x[i] = moved(x[i], dt);
    p[i] = f * p[i] * f.transpose();
    p[i].topLeftCorner<4, 4>() += whiteAcceleration(dt, densities[i]);
  }

  void mix(double dt) {
    const double begin = 1.0 - std::exp(-dt / params.straight_time), end = 1.0 - std::exp(-dt / params.turning_time);
    const double over = 1.0 - std::exp(-dt / params.free_time);
    const double turn = begin * 0.5 * (1.0 - params.free_share), other = begin * params.free_share;
    Matrix4 chain;
    chain << 1.0 - begin, turn, turn, other, end, 1.0 - end, 0.0, 0.0, end, 0.0, 1.0 - end, 0.0, over, 0.0, 0.0,
        1.0 - over;
    Vector5 mixed_x[kModels];
    Matrix5 mixed_p[kModels];
    double c[kModels];
    for (int j = 0; j < kModels; ++j) {
      c[j] = 0.0;
      mixed_x[j].setZero();
      mixed_p[j].setZero();
      Vector5 from_x[kModels];
      Matrix5 from_p[kModels];
      for (int i = 0; i < kModels; ++i) {
        c[j] += chain(i, j) * mu[i];
        from_x[i] = x[i];
        from_p[i] = p[i];
        if (i != j) forgetRate(from_x[i], from_p[i], j);
      }
      if (c[j] == 0.0) continue;
      for (int i = 0; i < kModels; ++i) mixed_x[j] += chain(i, j) * mu[i] / c[j] * from_x[i];
      for (int i = 0; i < kModels; ++i) {
        const Vector5 d = from_x[i] - mixed_x[j];
        mixed_p[j] += chain(i, j) * mu[i] / c[j] * (from_p[i] + d * d.transpose());
      }
    }
    for (int j = 0; j < kModels; ++j) {
      mu[j] = c[j];
      if (c[j] == 0.0) continue;
      x[j] = mixed_x[j];
      p[j] = mixed_p[j];
    }
  }

  double update(const PlanarPosition& z, double dt) { return update(z, {}, dt); }

  double update(const PlanarPosition& z, const RangeRate& rate, double dt) {
    mix(dt);
    Matrix25 h = Matrix25::Zero();
    h(0, 0) = h(1, 1) = 1.0;
    double sum = 0.0;
    for (int i = 0; i < kModels; ++i) {
      move(i, dt);
      const Eigen::Matrix2d s = h * p[i] * h.transpose() + denseOf(z.covariance);
      const Eigen::Vector2d innovation = Eigen::Vector2d(z.x, z.y) - h * x[i];
      const Eigen::Matrix<double, 5, 2> k = p[i] * h.transpose() * s.inverse();
      x[i] += k * innovation;
      p[i] = (Matrix5::Identity() - k * h) * p[i];
      if (rate.known()) mu[i] *= correctDensely(x[i], p[i], rate);
      const double side = i == 1 ? 1.0 : -1.0;
      if (rateSigma(i) > 0.0)
        x[i][4] = side * std::min(std::max(side * x[i][4], 0.15 * params.turn_rate), 3.0 * params.turn_rate);
      sum += mu[i] *= gaussian(innovation.dot(s.inverse() * innovation), s.determinant());
    }
    for (double& m : mu) m /= sum;
    return std::log(sum);
  }

  Vector4 mean() const {
    Vector4 sum = Vector4::Zero();
    for (int i = 0; i < kModels; ++i) sum += mu[i] * x[i].head<4>();
    return sum;
  }

  Matrix4 covariance() const {
    Matrix4 sum = Matrix4::Zero();
    for (int i = 0; i < kModels; ++i) {
      const Vector4 d = x[i].head<4>() - mean();
      sum += mu[i] * (p[i].topLeftCorner<4, 4>() + d * d.transpose());
    }
    return sum;
  }
};

}  // namespace tws
