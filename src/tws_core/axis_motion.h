#pragma once

#include <tws_core/filter_gains.h>

namespace tws {

/// How one coordinate moves at one instant: range or x in metres, azimuth in radians, and their derivatives by seconds.
struct AxisMotion {
  double position = 0.0;
  double velocity = 0.0;
  double acceleration = 0.0;
};

/// What a filter may assume of one coordinate; all in the coordinate's unit and seconds, > 0.
struct AxisNoise {
  double measurement = 1.0;   // σ_v: standard deviation of a measured position
  double acceleration = 1.0;  // σ_w: of the target's acceleration, which is constant over each interval
  double velocity = 1.0;      // of the target's velocity before it is known
};

/// The motion a time dt [s] later (Henery 1985, eq. (3.2)).
inline AxisMotion moved(const AxisMotion& motion, double dt) {
  return {motion.position + motion.velocity * dt + 0.5 * motion.acceleration * dt * dt,
          motion.velocity + motion.acceleration * dt, motion.acceleration};
}

/// What α, α-β, adaptive α-β and α-β-γ filters share (Henery 1985, eq. (3.9)): corrects a predicted state by an
/// innovation T [s] > 0 after the last one. A state without acceleration ignores gamma.
template <class State>
void correct(State& predicted, const FilterGains& gains, double innovation, double T) {
  predicted.position += gains.alpha * innovation;
  predicted.velocity += gains.beta / T * innovation;
}

}  // namespace tws
