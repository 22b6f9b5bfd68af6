#pragma once

#include <string>
#include <variant>
#include <vector>

#include <tws_core/alpha_beta.h>
#include <tws_core/axis_kalman.h>
#include <tws_core/fixed_gain_filter.h>
#include <tws_core/fixed_memory_filter.h>

namespace tws {

// Every axis filter F has the same shape, without a base class, so that loops over measurements are templates and make
// no virtual calls:
//
//   F::State                                                         one coordinate of one track
//   State      start(double position, const AxisNoise&) const        from its first measurement
//   AxisMotion F::motion(const State&)                               at the last measurement
//   void       update(State&, double innovation, double dt, const AxisNoise&) const
//
// moved(F::motion(state), dt) predicts. Filters hold constants only. Where the choice is made at run time, AxisFilter
// chooses once for each call, at the edge.

/// Which filter, and its constants; the defaults are a start for a surveillance radar.
struct AxisFilterParams {
  /// alpha, alpha_beta, alpha_beta_gamma: by the gains below; alpha_index, alpha_beta_index, alpha_beta_gamma_index: by
  /// Kalata's tracking index; adaptive_alpha_beta; kalman_cv, kalman_ca; fixed_memory, expanding_memory, fading_memory:
  /// polynomials of `degree`.
  std::string kind = "kalman_cv";
  double alpha = 0.6;   // (0, 2)
  double beta = 0.25;   // > 0; 4 - 2α - β > 0
  double gamma = 0.03;  // > 0; γ(2 - α) < 2αβ
  AdaptiveAlphaBetaParams adaptive;
  int degree = 1;      // 0, 1 or 2
  int length = 6;      // measurements of fixed memory, [degree + 1, 16]
  double theta = 0.6;  // of fading memory, [0, 1)
};

/// All kinds that AxisFilterParams knows.
const std::vector<std::string>& axisFilterKinds();

/// One of the filters, chosen at run time.
class AxisFilter {
 public:
  using State = std::variant<FixedGainState, AlphaBetaState, FixedMemoryState, AxisKalmanState<2>, AxisKalmanState<3>>;

  /// Throws std::invalid_argument that names the constant that does not fit the kind.
  explicit AxisFilter(const AxisFilterParams& params);

  State start(double position, const AxisNoise& noise) const;
  static AxisMotion motion(const State& state);
  /// As FixedGainFilter::update(). The state must come from this filter's start().
  void update(State& state, double innovation, double dt, const AxisNoise& noise) const;

 private:
  std::variant<FixedGainFilter, AdaptiveAlphaBeta, FixedMemoryFilter, AxisKalman<2>, AxisKalman<3>> filter_;
};

}  // namespace tws
