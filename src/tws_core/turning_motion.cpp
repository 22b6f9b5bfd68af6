#include <tws_core/turning_motion.h>

#include <cmath>

namespace tws {
namespace {

/// How position and velocity turn in a time step: p += A v, v = C v, with A = [a -b; b a] and C = [c -d; d c].
struct Turn {
  double a, b, c, d;
};

/// Exact for a constant turn rate [rad/s], anticlockwise positive.
Turn turnOf(double rate, double dt) {
  if (rate == 0.0) return {dt, 0.0, 1.0, 0.0};
  const double sine = std::sin(rate * dt), cosine = std::cos(rate * dt);
  return {sine / rate, (1.0 - cosine) / rate, cosine, sine};
}

/// What the state moves by for a unit of the rate.
struct RateEffect {
  double x, y, vx, vy;
};

RateEffect effectOfRate(const TurningMotion& s, const Turn& t, double dt) {
  double a = 0.0, b = 0.5 * dt * dt;
  if (s.rate != 0.0) {
    a = (dt * t.c - t.a) / s.rate;
    b = (dt * t.d - t.b) / s.rate;
  }
  return {a * s.vx - b * s.vy, b * s.vx + a * s.vy, -dt * (t.d * s.vx + t.c * s.vy), dt * (t.c * s.vx - t.d * s.vy)};
}

/// The position's block of F P F' + Q, with Q of white acceleration of density q.
Symmetric2 movedPosition(const PlanarMotion& s, const Turn& t, double dt, double q) {
  const double a = t.a, b = t.b, spread = q * dt * dt * dt / 3.0;
  const Symmetric2& v = s.velocity;
  // A·V, and (cross)·A'.
  const double av_xx = a * v.xx - b * v.xy, av_xy = a * v.xy - b * v.yy;
  const double av_yx = b * v.xx + a * v.xy, av_yy = b * v.xy + a * v.yy;
  const double ca_xx = a * s.x_vx - b * s.x_vy, ca_xy = b * s.x_vx + a * s.x_vy;
  const double ca_yx = a * s.y_vx - b * s.y_vy, ca_yy = b * s.y_vx + a * s.y_vy;
  return {s.position.xx + 2.0 * ca_xx + a * av_xx - b * av_xy + spread,
          s.position.xy + ca_xy + ca_yx + b * av_xx + a * av_xy,
          s.position.yy + 2.0 * ca_yy + b * av_yx + a * av_yy + spread};
}

/// P ← F P F' + Q, block by block, the rate left out.
void moveCovariance(PlanarMotion& s, const Turn& t, double dt, double q) {
  s.position = movedPosition(s, t, dt, q);
  const auto [a, b, c, d] = t;
  const Symmetric2 v = s.velocity;
  const double n_xx = s.x_vx + a * v.xx - b * v.xy, n_xy = s.x_vy + a * v.xy - b * v.yy;
  const double n_yx = s.y_vx + b * v.xx + a * v.xy, n_yy = s.y_vy + b * v.xy + a * v.yy;
  s.x_vx = c * n_xx - d * n_xy + q * dt * dt / 2.0;
  s.x_vy = d * n_xx + c * n_xy;
  s.y_vx = c * n_yx - d * n_yy;
  s.y_vy = d * n_yx + c * n_yy + q * dt * dt / 2.0;
  const double cv_xx = c * v.xx - d * v.xy, cv_xy = c * v.xy - d * v.yy;
  const double cv_yx = d * v.xx + c * v.xy, cv_yy = d * v.xy + c * v.yy;
  s.velocity = {c * cv_xx - d * cv_xy + q * dt, d * cv_xx + c * cv_xy, d * cv_yx + c * cv_yy + q * dt};
}

/// m ← m + a b' + b a'
void addProducts(Symmetric2& m, double ax, double ay, double bx, double by) {
  m.xx += 2.0 * ax * bx;
  m.xy += ax * by + bx * ay;
  m.yy += 2.0 * ay * by;
}

/// Of h = F c + g σ² / 2 (see addRate), the position's part.
struct HalfWay {
  double x, y;
};

HalfWay halfWay(const TurningMotion& s, const Turn& t, const RateEffect& g) {
  const double half = 0.5 * s.rate_variance;
  return {s.x_rate + t.a * s.vx_rate - t.b * s.vy_rate + half * g.x,
          s.y_rate + t.b * s.vx_rate + t.a * s.vy_rate + half * g.y};
}

/// What the rate's error adds: h g' + g h', with g the rate's effect and h = F c + g σ² / 2; c, the covariances with
/// the rate, becomes F c + g σ².
void addRate(TurningMotion& s, const Turn& t, const RateEffect& g) {
  const double half = 0.5 * s.rate_variance;
  const HalfWay place = halfWay(s, t, g);
  const double fvx = t.c * s.vx_rate - t.d * s.vy_rate, fvy = t.d * s.vx_rate + t.c * s.vy_rate;
  const RateEffect h{place.x, place.y, fvx + half * g.vx, fvy + half * g.vy};
  addProducts(s.position, h.x, h.y, g.x, g.y);
  s.x_vx += h.x * g.vx + g.x * h.vx;
  s.x_vy += h.x * g.vy + g.x * h.vy;
  s.y_vx += h.y * g.vx + g.y * h.vx;
  s.y_vy += h.y * g.vy + g.y * h.vy;
  addProducts(s.velocity, h.vx, h.vy, g.vx, g.vy);
  s.x_rate = h.x + half * g.x;
  s.y_rate = h.y + half * g.y;
  s.vx_rate = h.vx + half * g.vx;
  s.vy_rate = h.vy + half * g.vy;
}

}  // namespace

void advance(TurningMotion& s, double dt, double density) {
  const Turn t = turnOf(s.rate, dt);
  moveCovariance(s, t, dt, density);
  if (s.rate_variance > 0.0) addRate(s, t, effectOfRate(s, t, dt));
  const double vx = s.vx, vy = s.vy;
  s.x += t.a * vx - t.b * vy;
  s.y += t.b * vx + t.a * vy;
  s.vx = t.c * vx - t.d * vy;
  s.vy = t.d * vx + t.c * vy;
}

PlanarPosition advancedPosition(const TurningMotion& s, double dt, double density) {
  const Turn t = turnOf(s.rate, dt);
  PlanarPosition moved{s.x + t.a * s.vx - t.b * s.vy, s.y + t.b * s.vx + t.a * s.vy, movedPosition(s, t, dt, density)};
  if (s.rate_variance == 0.0) return moved;
  const RateEffect g = effectOfRate(s, t, dt);
  const HalfWay h = halfWay(s, t, g);
  addProducts(moved.covariance, h.x, h.y, g.x, g.y);
  return moved;
}

MeasurementFit correct(TurningMotion& s, const PlanarPosition& z) {
  const Symmetric2 S{s.position.xx + z.covariance.xx, s.position.xy + z.covariance.xy, s.position.yy + z.covariance.yy};
  const double inverse = 1.0 / S.determinant();
  const Symmetric2 W{S.yy * inverse, -S.xy * inverse, S.xx * inverse};
  const double nx = z.x - s.x, ny = z.y - s.y;
  const double d2 = W.xx * nx * nx + 2.0 * W.xy * nx * ny + W.yy * ny * ny;
  const double h[5][2] = {{s.position.xx, s.position.xy},
                          {s.position.xy, s.position.yy},
                          {s.x_vx, s.y_vx},
                          {s.x_vy, s.y_vy},
                          {s.x_rate, s.y_rate}};
  double k[5][2];
  for (int i = 0; i < 5; ++i) {
    k[i][0] = h[i][0] * W.xx + h[i][1] * W.xy;
    k[i][1] = h[i][0] * W.xy + h[i][1] * W.yy;
  }
  const auto gain = [&](int i) { return k[i][0] * nx + k[i][1] * ny; };
  const auto shrink = [&](int i, int j) { return k[i][0] * h[j][0] + k[i][1] * h[j][1]; };
  s.x += gain(0);
  s.y += gain(1);
  s.vx += gain(2);
  s.vy += gain(3);
  s.position.xx -= shrink(0, 0);
  s.position.xy -= shrink(0, 1);
  s.position.yy -= shrink(1, 1);
  s.x_vx -= shrink(0, 2);
  s.x_vy -= shrink(0, 3);
  s.y_vx -= shrink(1, 2);
  s.y_vy -= shrink(1, 3);
  s.velocity.xx -= shrink(2, 2);
  s.velocity.xy -= shrink(2, 3);
  s.velocity.yy -= shrink(3, 3);
  if (s.rate_variance > 0.0) {
    s.rate += gain(4);
    s.rate_variance -= shrink(4, 4);
    s.x_rate -= shrink(4, 0);
    s.y_rate -= shrink(4, 1);
    s.vx_rate -= shrink(4, 2);
    s.vy_rate -= shrink(4, 3);
  }
  return {d2, std::sqrt(inverse)};
}

void addMean(PlanarMotion& to, const PlanarMotion& from, double weight) {
  to.x += weight * from.x;
  to.y += weight * from.y;
  to.vx += weight * from.vx;
  to.vy += weight * from.vy;
}

void addMean(TurningMotion& to, const TurningMotion& from, double weight) {
  addMean(static_cast<PlanarMotion&>(to), from, weight);
  to.rate += weight * from.rate;
}

void addSpread(PlanarMotion& to, const PlanarMotion& from, double weight) {
  const double dx = from.x - to.x, dy = from.y - to.y, dvx = from.vx - to.vx, dvy = from.vy - to.vy;
  to.position.xx += weight * (from.position.xx + dx * dx);
  to.position.xy += weight * (from.position.xy + dx * dy);
  to.position.yy += weight * (from.position.yy + dy * dy);
  to.x_vx += weight * (from.x_vx + dx * dvx);
  to.x_vy += weight * (from.x_vy + dx * dvy);
  to.y_vx += weight * (from.y_vx + dy * dvx);
  to.y_vy += weight * (from.y_vy + dy * dvy);
  to.velocity.xx += weight * (from.velocity.xx + dvx * dvx);
  to.velocity.xy += weight * (from.velocity.xy + dvx * dvy);
  to.velocity.yy += weight * (from.velocity.yy + dvy * dvy);
}

void addSpread(TurningMotion& to, const TurningMotion& from, double weight) {
  addSpread(static_cast<PlanarMotion&>(to), from, weight);
  const double dr = from.rate - to.rate;
  to.rate_variance += weight * (from.rate_variance + dr * dr);
  to.x_rate += weight * (from.x_rate + dr * (from.x - to.x));
  to.y_rate += weight * (from.y_rate + dr * (from.y - to.y));
  to.vx_rate += weight * (from.vx_rate + dr * (from.vx - to.vx));
  to.vy_rate += weight * (from.vy_rate + dr * (from.vy - to.vy));
}

}  // namespace tws
