#include <tws_core/fixed_memory_filter.h>

#include <algorithm>
#include <utility>

#include <tws_core/axis_checks.h>

namespace tws {
namespace {

using Memory = std::array<double, FixedMemoryState::kMost>;

/// The least-squares polynomial at the newest measurement, as a sum of polynomials p that are orthogonal over the
/// times: p(k+1) = (t - mean)·p(k) - fall·p(k-1).
AxisMotion fitted(const FixedMemoryState& state, int degree) {
  const int n = state.measurements;
  Memory p{}, previous{};
  p.fill(1.0);
  AxisMotion jet{1.0, 0.0, 0.0}, previous_jet;  // p and its derivatives at t = 0
  AxisMotion sum{state.position[0], 0.0, 0.0};
  double previous_norm = 1.0;
  for (int k = 0; k <= std::min(degree, n - 1); ++k) {
    double norm = 0.0, mean = 0.0, weight = 0.0;
    for (int i = 0; i < n; ++i) {
      norm += p[i] * p[i];
      mean += state.time[i] * p[i] * p[i];
      weight += (state.position[i] - state.position[0]) * p[i];
    }
    mean /= norm;
    weight /= norm;
    sum = {sum.position + weight * jet.position, sum.velocity + weight * jet.velocity,
           sum.acceleration + weight * jet.acceleration};
    const double fall = k > 0 ? norm / previous_norm : 0.0;
    for (int i = 0; i < n; ++i) previous[i] = std::exchange(p[i], (state.time[i] - mean) * p[i] - fall * previous[i]);
    previous_jet =
        std::exchange(jet, {-mean * jet.position - fall * previous_jet.position,
                            jet.position - mean * jet.velocity - fall * previous_jet.velocity,
                            2.0 * jet.velocity - mean * jet.acceleration - fall * previous_jet.acceleration});
    previous_norm = norm;
  }
  return sum;
}

}  // namespace

FixedMemoryFilter::FixedMemoryFilter(int degree, int length) : degree_(degree), length_(length) {
  requireNumber(degree >= 0 && degree <= 2, "degree", degree, "0, 1 or 2");
  requireNumber(length > degree && length <= FixedMemoryState::kMost, "length", length, "in [degree + 1, 16]");
}

FixedMemoryState FixedMemoryFilter::start(double position, const AxisNoise& /*noise*/) const {
  State state;
  state.motion.position = state.position[0] = position;
  state.measurements = 1;
  return state;
}

void FixedMemoryFilter::remember(State& state, double measured, double dt) const {
  state.measurements = std::min(state.measurements + 1, length_);
  for (int i = state.measurements - 1; i > 0; --i) {
    state.position[i] = state.position[i - 1];
    state.time[i] = state.time[i - 1] - dt;
  }
  state.position[0] = measured;
}

void FixedMemoryFilter::update(State& state, double innovation, double dt, const AxisNoise& /*noise*/) const {
  requireUpdate(innovation, dt);
  if (dt == 0.0) return;
  remember(state, moved(state.motion, dt).position + innovation, dt);
  state.motion = fitted(state, degree_);
}

}  // namespace tws
