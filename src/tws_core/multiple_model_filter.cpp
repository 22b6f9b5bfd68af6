#include <tws_core/multiple_model_filter.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tws {
namespace {

constexpr double kLogTwoPi = 1.83787706640934548356;
using States = std::array<PlanarMotion, MultipleModelFilter::kModels>;
using Weights = std::array<double, MultipleModelFilter::kModels>;

/// How position and velocity turn in a time step: p += A v, v = C v, with A = [a -b; b a] and C = [c -d; d c].
struct Motion {
  double a, b, c, d;
};

/// Exact for a constant turn rate [rad/s], anticlockwise positive.
std::array<Motion, MultipleModelFilter::kModels> motions(double dt, double turn_rate) {
  const double sine = std::sin(turn_rate * dt), cosine = std::cos(turn_rate * dt);
  const double a = sine / turn_rate, b = (1.0 - cosine) / turn_rate;
  return {Motion{dt, 0.0, 1.0, 0.0}, Motion{a, b, cosine, sine}, Motion{a, -b, cosine, -sine}};
}

void moveMean(PlanarMotion& s, const Motion& m) {
  const double vx = s.vx, vy = s.vy;
  s.x += m.a * vx - m.b * vy;
  s.y += m.b * vx + m.a * vy;
  s.vx = m.c * vx - m.d * vy;
  s.vy = m.d * vx + m.c * vy;
}

/// The position's block of F P F' + Q, with Q of white acceleration of density q.
Symmetric2 movedPosition(const PlanarMotion& s, const Motion& m, double dt, double q) {
  const double a = m.a, b = m.b, spread = q * dt * dt * dt / 3.0;
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

/// P ← F P F' + Q, block by block.
void moveCovariance(PlanarMotion& s, const Motion& m, double dt, double q) {
  s.position = movedPosition(s, m, dt, q);
  const auto [a, b, c, d] = m;
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

/// A measurement's likelihood is density · exp(-squared_distance / 2) / 2π.
struct Fit {
  double squared_distance, density;
};

/// Kalman update with a position.
Fit correctModel(PlanarMotion& s, const PlanarPosition& z) {
  const Symmetric2 S{s.position.xx + z.covariance.xx, s.position.xy + z.covariance.xy, s.position.yy + z.covariance.yy};
  const double inverse = 1.0 / S.determinant();
  const Symmetric2 W{S.yy * inverse, -S.xy * inverse, S.xx * inverse};
  const double nx = z.x - s.x, ny = z.y - s.y;
  const double d2 = W.xx * nx * nx + 2.0 * W.xy * nx * ny + W.yy * ny * ny;
  const double h[4][2] = {
      {s.position.xx, s.position.xy}, {s.position.xy, s.position.yy}, {s.x_vx, s.y_vx}, {s.x_vy, s.y_vy}};
  double k[4][2];
  for (int i = 0; i < 4; ++i) {
    k[i][0] = h[i][0] * W.xx + h[i][1] * W.xy;
    k[i][1] = h[i][0] * W.xy + h[i][1] * W.yy;
  }
  s.x += k[0][0] * nx + k[0][1] * ny;
  s.y += k[1][0] * nx + k[1][1] * ny;
  s.vx += k[2][0] * nx + k[2][1] * ny;
  s.vy += k[3][0] * nx + k[3][1] * ny;
  const auto shrink = [&](int i, int j) { return k[i][0] * h[j][0] + k[i][1] * h[j][1]; };
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
  return {d2, std::sqrt(inverse)};
}

/// Adds weight · (covariance of `from` + spread of its mean about that of `to`) to the covariance of `to`.
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

void addMean(PlanarMotion& to, const PlanarMotion& from, double weight) {
  to.x += weight * from.x;
  to.y += weight * from.y;
  to.vx += weight * from.vx;
  to.vy += weight * from.vy;
}

PlanarMotion meanOf(const States& states, const Weights& weights) {
  PlanarMotion result;
  for (std::size_t i = 0; i < states.size(); ++i) addMean(result, states[i], weights[i]);
  return result;
}

/// One Gaussian with the mean and the covariance of the mixture.
PlanarMotion merged(const States& states, const Weights& weights) {
  PlanarMotion result = meanOf(states, weights);
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (weights[i] > 0.0) addSpread(result, states[i], weights[i]);
  }
  return result;
}

/// Of the nearest site [m²].
double squaredDistance(const PlanarMotion& s, const MultipleModelParams& params) {
  if (params.sites.empty()) return s.x * s.x + s.y * s.y;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& site : params.sites)
    least = std::min(least, (s.x - site.x) * (s.x - site.x) + (s.y - site.y) * (s.y - site.y));
  return least;
}

/// Density of the acceleration that straight flight at the assumed height h seems to have in slant range on the plane:
/// h²v²/r³, lasting dt [m²/s³].
double slantAcceleration(const PlanarMotion& s, double dt, const MultipleModelParams& params) {
  const double r2 = std::max(squaredDistance(s, params), params.assumed_height * params.assumed_height);
  if (r2 == 0.0) return 0.0;
  const double h2 = params.assumed_height * params.assumed_height, v2 = s.vx * s.vx + s.vy * s.vy;
  return h2 * h2 * v2 * v2 / (r2 * r2 * r2) * dt;
}

/// Density of the acceleration that each model assumes [m²/s³].
std::array<double, MultipleModelFilter::kModels> accelerations(const States& states, double dt,
                                                               const MultipleModelParams& params) {
  const double slant = slantAcceleration(states[0], dt, params);
  return {slant + params.straight_acceleration, slant + params.turning_acceleration,
          slant + params.turning_acceleration};
}

void move(States& states, double dt, const MultipleModelParams& params) {
  const auto motion = motions(dt, params.turn_rate);
  const auto acceleration = accelerations(states, dt, params);
  for (std::size_t i = 0; i < states.size(); ++i) {
    moveMean(states[i], motion[i]);
    moveCovariance(states[i], motion[i], dt, acceleration[i]);
  }
}

/// Squared distance of a measurement from a prediction, in standard deviations.
double surprise(const PlanarMotion& s, const PlanarPosition& z) {
  const Symmetric2 S{s.position.xx + z.covariance.xx, s.position.xy + z.covariance.xy, s.position.yy + z.covariance.yy};
  return S.mahalanobis(z.x - s.x, z.y - s.y);
}

/// A measurement further away than this from all models is a hard manoeuvre, and so rare.
constexpr double kSurprise = 16.0;
constexpr double kLogManoeuvre = -4.6;  // ln 0.01

/// Covariance of an unknown constant acceleration over dt.
void addManoeuvre(PlanarMotion& s, double dt, double acceleration) {
  const double a2 = acceleration * acceleration, t2 = dt * dt;
  s.position.xx += 0.25 * a2 * t2 * t2;
  s.position.yy += 0.25 * a2 * t2 * t2;
  s.x_vx += 0.5 * a2 * t2 * dt;
  s.y_vy += 0.5 * a2 * t2 * dt;
  s.velocity.xx += a2 * t2;
  s.velocity.yy += a2 * t2;
}

}  // namespace

void MultipleModelFilter::start(const PlanarPosition& z, const MultipleModelParams& params) {
  PlanarMotion first;
  first.x = z.x;
  first.y = z.y;
  first.position = z.covariance;
  first.velocity = {params.speed_sigma * params.speed_sigma, 0.0, params.speed_sigma * params.speed_sigma};
  state_.fill(first);
  if (params.fast_speed_sigma > 0.0) {
    const double fast = params.fast_speed_sigma * params.fast_speed_sigma;
    state_[1].velocity = state_[2].velocity = {fast, 0.0, fast};
  }
  const double straight = params.straight_time / (params.straight_time + params.turning_time);
  probability_ = {straight, 0.5 * (1.0 - straight), 0.5 * (1.0 - straight)};
}

void MultipleModelFilter::setVelocity(double vx, double vy, const Symmetric2& covariance) {
  for (PlanarMotion& s : state_) {
    s.vx = vx;
    s.vy = vy;
    s.velocity = covariance;
  }
}

void MultipleModelFilter::mix(double dt, const MultipleModelParams& params) {
  const double begin = 1.0 - std::exp(-dt / params.straight_time), end = 1.0 - std::exp(-dt / params.turning_time);
  // A turn ends in straight flight; it does not change its side.
  const double transition[kModels][kModels] = {
      {1.0 - begin, 0.5 * begin, 0.5 * begin}, {end, 1.0 - end, 0.0}, {end, 0.0, 1.0 - end}};
  States mixed;
  Weights next;
  for (std::size_t to = 0; to < kModels; ++to) {
    Weights weight;
    double sum = 0.0;
    for (std::size_t from = 0; from < kModels; ++from) sum += weight[from] = transition[from][to] * probability_[from];
    for (double& w : weight) w /= sum;
    next[to] = sum;
    mixed[to] = merged(state_, weight);
  }
  state_ = mixed;
  probability_ = next;
}

double MultipleModelFilter::update(const PlanarPosition& z, double dt, const MultipleModelParams& params) {
  mix(dt, params);
  move(state_, dt, params);
  return correctBy(z, dt, params);
}

/// The measurement alone, after the move of dt [s].
double MultipleModelFilter::correctBy(const PlanarPosition& z, double dt, const MultipleModelParams& params) {
  const bool manoeuvre =
      params.manoeuvre_acceleration > 0.0 &&
      std::all_of(state_.begin(), state_.end(), [&](const PlanarMotion& s) { return surprise(s, z) > kSurprise; });
  if (manoeuvre) {
    for (PlanarMotion& s : state_) addManoeuvre(s, dt, params.manoeuvre_acceleration);
  }
  std::array<Fit, kModels> fit{};
  for (std::size_t i = 0; i < kModels; ++i) fit[i] = correctModel(state_[i], z);
  // All against the best fit, or a measurement far from every model would give 0 / 0.
  const double least = std::min({fit[0].squared_distance, fit[1].squared_distance, fit[2].squared_distance});
  double sum = 0.0;
  for (std::size_t i = 0; i < kModels; ++i) {
    sum += probability_[i] *= fit[i].density * std::exp(0.5 * (least - fit[i].squared_distance));
  }
  // A floor keeps a model from dying for good by underflow.
  for (double& p : probability_) p = std::max(p / sum, 1e-12);
  return std::log(sum) - 0.5 * least - kLogTwoPi + (manoeuvre ? kLogManoeuvre : 0.0);
}

void MultipleModelFilter::update(const std::vector<Weighed>& measurements, double missed, double dt,
                                 const MultipleModelParams& params) {
  mix(dt, params);
  move(state_, dt, params);
  std::vector<MultipleModelFilter> cases;
  cases.reserve(measurements.size() + 1);
  const auto add = [&](double chance) {
    for (double& p : cases.back().probability_) p *= chance;
  };
  cases.push_back(*this);
  add(missed);
  for (const Weighed& z : measurements) {
    cases.push_back(*this);
    cases.back().correctBy(z.position, dt, params);
    add(z.chance);
  }
  for (std::size_t model = 0; model < kModels; ++model) merge(cases, model);
}

/// One model in all cases becomes one Gaussian; its probability is what those of the cases add up to.
void MultipleModelFilter::merge(const std::vector<MultipleModelFilter>& cases, std::size_t model) {
  double sum = 0.0;
  for (const auto& c : cases) sum += c.probability_[model];
  PlanarMotion result;
  for (const auto& c : cases) addMean(result, c.state_[model], c.probability_[model] / sum);
  for (const auto& c : cases) {
    const double weight = c.probability_[model] / sum;
    if (weight > 0.0) addSpread(result, c.state_[model], weight);
  }
  state_[model] = result;
  probability_[model] = std::max(sum, 1e-12);
}

void MultipleModelFilter::shift(double dx, double dy) {
  for (PlanarMotion& state : state_) {
    state.x += dx;
    state.y += dy;
  }
}

PlanarMotion MultipleModelFilter::mean() const { return meanOf(state_, probability_); }

PlanarMotion MultipleModelFilter::predict(double dt, const MultipleModelParams& params) const {
  States moved = state_;
  move(moved, dt, params);
  return merged(moved, probability_);
}

PlanarPosition MultipleModelFilter::predictPosition(double dt, const MultipleModelParams& params) const {
  const auto motion = motions(dt, params.turn_rate);
  const auto acceleration = accelerations(state_, dt, params);
  std::array<PlanarPosition, kModels> moved;
  PlanarPosition result;
  for (std::size_t i = 0; i < kModels; ++i) {
    const PlanarMotion& s = state_[i];
    moved[i] = {s.x + motion[i].a * s.vx - motion[i].b * s.vy, s.y + motion[i].b * s.vx + motion[i].a * s.vy,
                movedPosition(s, motion[i], dt, acceleration[i])};
    result.x += probability_[i] * moved[i].x;
    result.y += probability_[i] * moved[i].y;
  }
  for (std::size_t i = 0; i < kModels; ++i) {
    const double dx = moved[i].x - result.x, dy = moved[i].y - result.y;
    result.covariance.xx += probability_[i] * (moved[i].covariance.xx + dx * dx);
    result.covariance.xy += probability_[i] * (moved[i].covariance.xy + dx * dy);
    result.covariance.yy += probability_[i] * (moved[i].covariance.yy + dy * dy);
  }
  return result;
}

}  // namespace tws
