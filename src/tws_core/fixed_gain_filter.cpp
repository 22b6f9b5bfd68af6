#include <tws_core/fixed_gain_filter.h>

#include <tws_core/axis_checks.h>

namespace tws {

FixedGainFilter::FixedGainFilter(int degree, const FilterGains& gains, bool by_index)
    : degree_(degree), steady_(gains), by_index_(by_index) {
  requireNumber(degree >= 0 && degree <= 2, "degree", degree, "0, 1 or 2");
}

FixedGainFilter FixedGainFilter::withGains(const FilterGains& gains) {
  requireNumber(isStable(gains), "alpha", gains.alpha,
                "such that with beta and gamma the filter is stable: 0 < alpha < 2; 4 - 2 alpha - beta > 0; "
                "gamma (2 - alpha) < 2 alpha beta");
  return {degreeOf(gains), gains, false};
}

FixedGainFilter FixedGainFilter::byTrackingIndex(int degree) { return {degree, {}, true}; }

FixedGainFilter FixedGainFilter::expandingMemory(int degree) { return {degree, {}, false}; }

FixedGainFilter FixedGainFilter::fadingMemory(int degree, double theta) {
  requireNumber(theta >= 0.0 && theta < 1.0, "theta", theta, "in [0, 1)");
  return {degree, fadingGains(degree, theta), false};
}

FilterGains FixedGainFilter::gainsAt(int n, double dt, const AxisNoise& noise) const {
  const FilterGains steady =
      by_index_ ? steadyGains(degree_, trackingIndex(noise.acceleration, noise.measurement, dt)) : steady_;
  const FilterGains expanding = expandingGains(degree_, n);
  const bool settled = n > degree_ + 1 && expanding.alpha <= steady.alpha;
  return settled ? steady : expanding;
}

void FixedGainFilter::update(State& state, double innovation, double dt, const AxisNoise& noise) const {
  requireUpdate(innovation, dt);
  if (dt == 0.0) return;
  const FilterGains gains = gainsAt(++state.measurements, dt, noise);
  const AxisMotion predicted = moved(motion(state), dt);
  state.position = predicted.position;
  state.velocity = predicted.velocity;
  correct(state, gains, innovation, dt);
  state.acceleration += gains.gamma / (dt * dt) * innovation;
}

}  // namespace tws
