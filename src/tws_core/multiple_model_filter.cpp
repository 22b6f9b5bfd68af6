#include <tws_core/multiple_model_filter.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tws {
namespace {

constexpr double kLogTwoPi = 1.83787706640934548356;
using States = std::array<TurningMotion, MultipleModelFilter::kModels>;
using Weights = std::array<double, MultipleModelFilter::kModels>;
enum Model : std::size_t { kStraight, kLeft, kRight, kFree };

/// Turn rate of a model when its motion begins, anticlockwise positive.
double firstRate(std::size_t model, const MultipleModelParams& params) {
  if (model == kLeft) return params.turn_rate;
  return model == kRight ? -params.turn_rate : 0.0;
}

/// The rate of a turn that begins now: nothing is known of it yet.
void forgetRate(TurningMotion& s, std::size_t model, const MultipleModelParams& params) {
  const bool turns = model == kLeft || model == kRight;
  s.rate = firstRate(model, params);
  s.rate_variance = turns ? params.turn_rate_sigma * params.turn_rate_sigma : 0.0;
  s.x_rate = s.y_rate = s.vx_rate = s.vy_rate = 0.0;
}

/// A turn keeps its side, and no aircraft turns at many times the usual rate.
void limitRate(TurningMotion& s, std::size_t model, const MultipleModelParams& params) {
  constexpr double kLeast = 0.15, kMost = 3.0;  // Of the usual one.
  const double side = model == kLeft ? 1.0 : -1.0;
  s.rate = side * std::clamp(side * s.rate, kLeast * params.turn_rate, kMost * params.turn_rate);
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

/// The same of two, with their rates.
TurningMotion merged(const TurningMotion& a, double weight_a, const TurningMotion& b, double weight_b) {
  TurningMotion result;
  addMean(result, a, weight_a);
  addMean(result, b, weight_b);
  addSpread(result, a, weight_a);
  addSpread(result, b, weight_b);
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
Weights accelerations(const States& states, double dt, const MultipleModelParams& params) {
  const double slant = slantAcceleration(states[kStraight], dt, params);
  const double turning = slant + params.turning_acceleration;
  return {slant + params.straight_acceleration, turning, turning, slant + params.free_acceleration};
}

void move(States& states, double dt, const MultipleModelParams& params) {
  const Weights acceleration = accelerations(states, dt, params);
  for (std::size_t i = 0; i < states.size(); ++i) advance(states[i], dt, acceleration[i]);
}

/// Chances that each model takes the place of another within dt: a manoeuvre ends in straight flight.
struct Transitions {
  Transitions(double dt, const MultipleModelParams& params)
      : begin(1.0 - std::exp(-dt / params.straight_time)), free(params.free_share) {
    const double turned = 1.0 - std::exp(-dt / params.turning_time);
    end = {0.0, turned, turned, 1.0 - std::exp(-dt / params.free_time)};
  }
  /// Share of the manoeuvres that begin so.
  double share(std::size_t to) const { return to == kFree ? free : 0.5 * (1.0 - free); }
  double intoStraight(std::size_t from) const { return from == kStraight ? 1.0 - begin : end[from]; }

  double begin, free;
  Weights end;
};

/// Squared distance of a measurement from a prediction, in standard deviations.
double surprise(const PlanarMotion& s, const PlanarPosition& z) {
  const Symmetric2 S{s.position.xx + z.covariance.xx, s.position.xy + z.covariance.xy, s.position.yy + z.covariance.yy};
  return S.mahalanobis(z.x - s.x, z.y - s.y);
}

/// A measurement further away than this from all models is a hard manoeuvre, and so rare.
constexpr double kSurprise = 16.0;
constexpr double kLogManoeuvre = -4.6;  // ln 0.01

/// The fit of a position and that of a range rate together.
void add(MeasurementFit& fit, const MeasurementFit& rate) {
  fit.squared_distance += rate.squared_distance;
  fit.density *= rate.density;
}

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
  TurningMotion first;
  first.x = z.x;
  first.y = z.y;
  first.position = z.covariance;
  first.velocity = {params.speed_sigma * params.speed_sigma, 0.0, params.speed_sigma * params.speed_sigma};
  state_.fill(first);
  for (const std::size_t model : {kLeft, kRight, kFree}) forgetRate(state_[model], model, params);
  const double manoeuvring = params.turning_time / (params.straight_time + params.turning_time);
  double free = manoeuvring * params.free_share;
  const double turns = 0.5 * (manoeuvring - free), known = 1.0 - free;
  if (params.fast_speed_sigma > 0.0) {
    const double fast = params.fast_speed_sigma * params.fast_speed_sigma;
    state_[kFree].velocity = {fast, 0.0, fast};
    free = params.fast_share;
  }
  const double rest = (1.0 - free) / known;
  probability_ = {(1.0 - manoeuvring) * rest, turns * rest, turns * rest, free};
}

void MultipleModelFilter::setVelocity(double vx, double vy, const Symmetric2& covariance) {
  for (TurningMotion& s : state_) {
    s.vx = vx;
    s.vy = vy;
    s.velocity = covariance;
  }
}

void MultipleModelFilter::mix(double dt, const MultipleModelParams& params) {
  const Transitions transitions(dt, params);
  const States before = state_;
  Weights weight;
  for (std::size_t i = 0; i < kModels; ++i) weight[i] = transitions.intoStraight(i) * probability_[i];
  const double straight = weight[0] + weight[1] + weight[2] + weight[3];
  for (double& w : weight) w /= straight;
  static_cast<PlanarMotion&>(state_[kStraight]) = merged(before, weight);
  for (const std::size_t model : {kLeft, kRight, kFree}) {
    const double began = transitions.begin * transitions.share(model) * probability_[kStraight];
    const double lasts = (1.0 - transitions.end[model]) * probability_[model];
    if (began + lasts == 0.0) continue;  // There is no such model.
    TurningMotion fresh = before[kStraight];
    forgetRate(fresh, model, params);
    state_[model] = merged(before[model], lasts / (began + lasts), fresh, began / (began + lasts));
    probability_[model] = began + lasts;
  }
  probability_[kStraight] = straight;
}

double MultipleModelFilter::update(const PlanarPosition& z, const RangeRate& rate, double dt,
                                   const MultipleModelParams& params) {
  mix(dt, params);
  move(state_, dt, params);
  return correctBy(z, rate, dt, params);
}

/// The measurement alone, after the move of dt [s].
double MultipleModelFilter::correctBy(const PlanarPosition& z, const RangeRate& rate, double dt,
                                      const MultipleModelParams& params) {
  const auto surprises = [&](const PlanarMotion& s) {
    return surprise(s, z) > kSurprise || (rate.known() && fitOf(s, rate).squared_distance > kSurprise);
  };
  const bool manoeuvre = params.manoeuvre_acceleration > 0.0 && std::all_of(state_.begin(), state_.end(), surprises);
  if (manoeuvre) {
    for (TurningMotion& s : state_) addManoeuvre(s, dt, params.manoeuvre_acceleration);
  }
  std::array<MeasurementFit, kModels> fit{};
  for (std::size_t i = 0; i < kModels; ++i) fit[i] = correct(state_[i], z);
  if (rate.known()) {
    for (std::size_t i = 0; i < kModels; ++i) add(fit[i], correct(state_[i], rate));
  }
  if (params.turn_rate_sigma > 0.0) {
    for (const std::size_t model : {kLeft, kRight}) limitRate(state_[model], model, params);
  }
  return weigh(fit) - kLogTwoPi + (manoeuvre ? kLogManoeuvre : 0.0);
}

double MultipleModelFilter::correctBy(const RangeRate& rate) {
  std::array<MeasurementFit, kModels> fit{};
  for (std::size_t i = 0; i < kModels; ++i) fit[i] = correct(state_[i], rate);
  return weigh(fit);
}

/// The chances of the models after a measurement that they fit so; returns the logarithm of its likelihood, their
/// common factor left out.
double MultipleModelFilter::weigh(const std::array<MeasurementFit, kModels>& fit) {
  // All against the best fit, or a measurement far from every model would give 0 / 0.
  double least = fit[kStraight].squared_distance;
  for (const MeasurementFit& f : fit) least = std::min(least, f.squared_distance);
  const Weights before = probability_;
  double sum = 0.0;
  for (std::size_t i = 0; i < kModels; ++i) {
    sum += probability_[i] *= fit[i].density * std::exp(0.5 * (least - fit[i].squared_distance));
  }
  // A floor keeps a model, where there is such a one, from dying for good by underflow.
  for (std::size_t i = 0; i < kModels; ++i) {
    if (before[i] > 0.0) probability_[i] = std::max(probability_[i] / sum, 1e-12);
  }
  return std::log(sum) - 0.5 * least;
}

void MultipleModelFilter::update(const std::vector<Weighed>& measurements, double missed, double dt,
                                 const MultipleModelParams& params) {
  mix(dt, params);
  move(state_, dt, params);
  std::vector<MultipleModelFilter> cases;
  cases.reserve(measurements.size() + 1);
  const auto count = [&](double chance) {
    for (double& p : cases.back().probability_) p *= chance;
  };
  cases.push_back(*this);
  count(missed);
  for (const Weighed& z : measurements) {
    cases.push_back(*this);
    cases.back().correctBy(z.position, z.rate, dt, params);
    count(z.chance);
  }
  for (std::size_t model = 0; model < kModels; ++model) merge(cases, model);
}

/// One model in all cases becomes one Gaussian; its probability is what those of the cases add up to.
void MultipleModelFilter::merge(const std::vector<MultipleModelFilter>& cases, std::size_t model) {
  double sum = 0.0;
  for (const auto& c : cases) sum += c.probability_[model];
  if (sum == 0.0) return;
  TurningMotion result;
  for (const auto& c : cases) addMean(result, c.state_[model], c.probability_[model] / sum);
  for (const auto& c : cases) {
    const double weight = c.probability_[model] / sum;
    if (weight > 0.0) addSpread(result, c.state_[model], weight);
  }
  state_[model] = result;
  probability_[model] = std::max(sum, 1e-12);
}

void MultipleModelFilter::shift(double dx, double dy) {
  for (TurningMotion& state : state_) {
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
  const Weights acceleration = accelerations(state_, dt, params);
  std::array<PlanarPosition, kModels> moved;
  PlanarPosition result;
  for (std::size_t i = 0; i < kModels; ++i) {
    if (probability_[i] == 0.0) continue;
    moved[i] = advancedPosition(state_[i], dt, acceleration[i]);
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
