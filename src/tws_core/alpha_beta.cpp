#include <tws_core/alpha_beta.h>

#include <algorithm>

#include <tws_core/axis_checks.h>

namespace tws {
namespace {

double checkedDamping(const AdaptiveAlphaBetaParams& params) {
  check(params);
  return params.damping;
}

}  // namespace

AlphaBetaGains gains(double omega0_T1, double damping) {
  const double decay = damping * omega0_T1;
  const double half_turn = 0.5 * omega0_T1 * std::sqrt(1.0 - damping * damping);  // ω_d·T₁/2
  // (3) as (1 - e^-d)² + 4·e^-d·sin²(ω_d·T₁/2): the same, without the difference of nearly equal numbers for small
  // ω₀·T₁.
  const double rise = std::expm1(-decay);
  const double sine = std::sin(half_turn);
  return {-std::expm1(-2.0 * decay), rise * rise + 4.0 * std::exp(-decay) * sine * sine};
}

GainTable::GainTable(double damping, double step, double greatest)
    : damping_(damping), entries_per_radian_(1.0 / step) {
  requireNumber(damping > 0.0 && damping < 1.0, "damping", damping, "in (0, 1)");
  requireNumber(step > 0.0 && step <= 1.0, "step", step, "in (0, 1]");
  requireNumber(greatest >= step && greatest <= 100.0, "greatest", greatest, "in [step, 100]");
  const auto entries = static_cast<std::size_t>(std::ceil(greatest / step)) + 1;
  table_.reserve(entries);
  for (std::size_t i = 0; i < entries; ++i) table_.push_back(gains(static_cast<double>(i) * step, damping));
  entries_ = static_cast<double>(entries);
}

void check(const AdaptiveAlphaBetaParams& params) {
  const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
  requireNumber(params.damping > 0.0 && params.damping < 1.0, "damping", params.damping, "in (0, 1)");
  requireNumber(positive(params.omega_a), "omega_a", params.omega_a, "above 0 rad/s");
  requireNumber(positive(params.omega_b), "omega_b", params.omega_b, "above 0 rad/s");
  requireNumber(positive(params.omega_min), "omega_min", params.omega_min, "above 0 rad/s");
  requireNumber(std::isfinite(params.omega_max) && params.omega_max >= params.omega_min, "omega_max", params.omega_max,
                "at least omega_min");
}

AdaptiveAlphaBeta::AdaptiveAlphaBeta(const AdaptiveAlphaBetaParams& params)
    : params_(params), table_(checkedDamping(params)) {}

void AdaptiveAlphaBeta::adapt(AlphaBetaState& state, double innovation, double T1) const {
  // The first error has no predecessor: p₁ and p₂ stay alike.
  if (!std::isnan(state.last_error)) {
    const double keep_a = std::exp(-params_.omega_a * T1);
    const double keep_b = params_.omega_b == params_.omega_a ? keep_a : std::exp(-params_.omega_b * T1);
    state.p1 = keep_a * state.p1 + (1.0 - keep_a) * innovation * state.last_error;  // (4)
    state.p2 = keep_b * state.p2 + (1.0 - keep_b) * innovation * innovation;        // (5)
  }
  state.last_error = innovation;
  const double omega0 = state.p2 > 0.0 ? 0.5 * std::abs(state.p1 / state.p2) : params_.omega_max;  // (6)
  state.omega0 = std::clamp(omega0, params_.omega_min, params_.omega_max);
}

void AdaptiveAlphaBeta::update(AlphaBetaState& state, double innovation, double T1) const {
  requireNumber(T1 >= 0.0 && std::isfinite(T1), "T1", T1, "a time of at least 0 s");
  requireNumber(std::isfinite(innovation), "innovation", innovation, "finite");
  const double predicted = predict(state, T1);
  adapt(state, innovation, T1);
  if (T1 == 0.0) return;
  const AlphaBetaGains gain = table_.lookup(state.omega0 * T1);
  state.position = predicted;
  correct(state, {gain.alpha, gain.beta, 0.0}, innovation, T1);  // (1a); (1b), read as β/T₁
}

}  // namespace tws
