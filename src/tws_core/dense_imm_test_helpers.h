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

/// Neither slant range nor hard manoeuvres: what the textbook has.
inline MultipleModelParams textbook() {
  MultipleModelParams params;
  params.assumed_height = 0.0;
  params.manoeuvre_acceleration = 0.0;
  return params;
}

inline double gaussian(double squared, double determinant) {
  return std::exp(-0.5 * squared) / (2.0 * kPi * std::sqrt(determinant));
}

/// Interacting multiple models as in Bar-Shalom, Li & Kirubarajan, "Estimation with Applications to Tracking and
/// Navigation", section 11.6.6, with dense matrices.
struct DenseImm {
  static constexpr int kModels = 3;
  MultipleModelParams params = textbook();
  Vector4 x[kModels];
  Matrix4 p[kModels];
  double mu[kModels];

  void start(const PlanarPosition& z) {
    const double straight = params.straight_time / (params.straight_time + params.turning_time);
    for (int i = 0; i < kModels; ++i) {
      x[i] = {z.x, z.y, 0.0, 0.0};
      p[i] = Matrix4::Zero();
      p[i].topLeftCorner<2, 2>() = denseOf(z.covariance);
      p[i].bottomRightCorner<2, 2>() = Eigen::Matrix2d::Identity() * params.speed_sigma * params.speed_sigma;
      mu[i] = i == 0 ? straight : 0.5 * (1.0 - straight);
    }
  }

  void move(int i, double dt) {
    const double rate = i == 0 ? 0.0 : (i == 1 ? params.turn_rate : -params.turn_rate);
    const Matrix4 f = transition(dt, rate);
    x[i] = f * x[i];
    p[i] = f * p[i] * f.transpose() +
           whiteAcceleration(dt, i == 0 ? params.straight_acceleration : params.turning_acceleration);
  }

  void mix(double dt) {
    const double begin = 1.0 - std::exp(-dt / params.straight_time), end = 1.0 - std::exp(-dt / params.turning_time);
    Eigen::Matrix3d chain;
    chain << 1.0 - begin, begin / 2.0, begin / 2.0, end, 1.0 - end, 0.0, end, 0.0, 1.0 - end;
    Vector4 mixed_x[kModels];
    Matrix4 mixed_p[kModels];
    double c[kModels];
    for (int j = 0; j < kModels; ++j) {
      c[j] = 0.0;
      mixed_x[j].setZero();
      mixed_p[j].setZero();
      for (int i = 0; i < kModels; ++i) c[j] += chain(i, j) * mu[i];
      for (int i = 0; i < kModels; ++i) mixed_x[j] += chain(i, j) * mu[i] / c[j] * x[i];
      for (int i = 0; i < kModels; ++i) {
        const Vector4 d = x[i] - mixed_x[j];
        mixed_p[j] += chain(i, j) * mu[i] / c[j] * (p[i] + d * d.transpose());
      }
    }
    for (int j = 0; j < kModels; ++j) {
      x[j] = mixed_x[j];
      p[j] = mixed_p[j];
      mu[j] = c[j];
    }
  }

  double update(const PlanarPosition& z, double dt) {
    mix(dt);
    Matrix24 h = Matrix24::Zero();
    h(0, 0) = h(1, 1) = 1.0;
    double sum = 0.0;
    for (int i = 0; i < kModels; ++i) {
      move(i, dt);
      const Eigen::Matrix2d s = h * p[i] * h.transpose() + denseOf(z.covariance);
      const Eigen::Vector2d innovation = Eigen::Vector2d(z.x, z.y) - h * x[i];
      const Eigen::Matrix<double, 4, 2> k = p[i] * h.transpose() * s.inverse();
      x[i] += k * innovation;
      p[i] = (Matrix4::Identity() - k * h) * p[i];
      sum += mu[i] *= gaussian(innovation.dot(s.inverse() * innovation), s.determinant());
    }
    for (double& m : mu) m /= sum;
    return std::log(sum);
  }

  Vector4 mean() const { return mu[0] * x[0] + mu[1] * x[1] + mu[2] * x[2]; }

  Matrix4 covariance() const {
    Matrix4 sum = Matrix4::Zero();
    for (int i = 0; i < kModels; ++i) {
      const Vector4 d = x[i] - mean();
      sum += mu[i] * (p[i] + d * d.transpose());
    }
    return sum;
  }
};

}  // namespace tws
