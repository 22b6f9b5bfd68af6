#pragma once

#include <cmath>
#include <limits>
#include <vector>

#include <tws_core/axis_motion.h>

namespace tws {

struct AlphaBetaGains {
  double alpha = 0.0;  // of the innovation, into position
  double beta = 0.0;   // of the innovation divided by T1, into velocity
};

/// NRL Report 7952, eqs. (2) and (3), exactly. omega0_T1 = ω₀·T₁ ≥ 0 [rad], damping ξ in (0, 1). No check.
AlphaBetaGains gains(double omega0_T1, double damping);

/// The same from a table over quantised ω₀·T₁, as the report stores them (ALPHA, BETA). The nearest entry is taken:
/// alpha is off by at most ξ·step, beta by at most (1 + ξ)·step. Beyond the table's end the exact function answers.
class GainTable {
 public:
  /// Throws std::invalid_argument unless damping is in (0, 1), step in (0, 1] and greatest in [step, 100].
  explicit GainTable(double damping, double step = 1.0 / 1024.0, double greatest = 8.0);

  AlphaBetaGains lookup(double omega0_T1) const {
    const double entry = omega0_T1 * entries_per_radian_ + 0.5;
    return entry >= 0.0 && entry < entries_ ? table_[static_cast<std::size_t>(entry)] : gains(omega0_T1, damping_);
  }
  double damping() const { return damping_; }

 private:
  double damping_;
  double entries_per_radian_;
  double entries_;
  std::vector<AlphaBetaGains> table_;
};

/// The constants of the adaptive filter. The report gives none of them.
struct AdaptiveAlphaBetaParams {
  double damping = 0.7;     // ξ, underdamped only: in (0, 1)
  double omega_a = 0.05;    // bandwidth of the low-pass p₁ [rad/s], > 0
  double omega_b = 0.05;    // bandwidth of the low-pass p₂ [rad/s], > 0
  double omega_min = 0.05;  // least ω₀ [rad/s], > 0
  double omega_max = 0.5;   // greatest ω₀ [rad/s], ≥ omega_min; eq. (6) gives 0.5 for errors all alike
};

/// Throws std::invalid_argument that names the first parameter out of range, its value and the range.
void check(const AdaptiveAlphaBetaParams& params);

/// One coordinate of one track: range in metres or azimuth in radians. (axis_filter.h has the other filters.)
struct AlphaBetaState {
  double position = 0.0;                                         // x_s
  double velocity = 0.0;                                         // v_s, per second
  double p1 = 0.0;                                               // low-pass of ξ(k)·ξ(k-1)
  double p2 = 0.0;                                               // low-pass of ξ(k)²
  double omega0 = 0.0;                                           // bandwidth of the last update [rad/s]
  double last_error = std::numeric_limits<double>::quiet_NaN();  // ξ(k-1); NaN: no update yet
};

/// The adaptive α-β filter of NRL Report 7952, section "Smoothing Filter", eqs. (1)-(6). It holds constants only; one
/// object serves all tracks. The readings: the velocity gain is β/T₁; p₁ is a unity-gain low-pass with ω_a, p₂ one with
/// ω_b; both start alike, so that ω₀ starts at its greatest.
class AdaptiveAlphaBeta {
 public:
  explicit AdaptiveAlphaBeta(const AdaptiveAlphaBetaParams& params);

  /// `error_power`: p₁ = p₂ at the start, a typical squared error; the larger, the longer ω₀ stays high.
  /// 0: the errors themselves decide from the second update on.
  AlphaBetaState start(double position, double velocity = 0.0, double error_power = 0.0) const {
    return {position, velocity, error_power, error_power, params_.omega_max, std::numeric_limits<double>::quiet_NaN()};
  }

  /// Position a time dt [s] after the last update, of either sign.
  static double predict(const AlphaBetaState& state, double dt) { return state.position + state.velocity * dt; }

  /// Takes in a measurement T1 [s] after the last update. `innovation` is measured minus predict(state, T1); for an
  /// azimuth the caller wraps it, and the position afterwards. T1 = 0 changes neither position nor velocity. Throws
  /// std::invalid_argument, and changes nothing, when T1 is negative or either number is not finite.
  void update(AlphaBetaState& state, double innovation, double T1) const;

  // The shape of all axis filters, see axis_filter.h. The filter finds out by itself how large errors are.
  using State = AlphaBetaState;
  AlphaBetaState start(double position, const AxisNoise& /*noise*/) const { return start(position); }
  static AxisMotion motion(const AlphaBetaState& state) { return {state.position, state.velocity, 0.0}; }
  void update(AlphaBetaState& state, double innovation, double dt, const AxisNoise& /*noise*/) const {
    update(state, innovation, dt);
  }

  const AdaptiveAlphaBetaParams& params() const { return params_; }

 private:
  void adapt(AlphaBetaState& state, double innovation, double T1) const;

  AdaptiveAlphaBetaParams params_;
  GainTable table_;
};

}  // namespace tws
