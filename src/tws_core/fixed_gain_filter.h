#pragma once

#include <tws_core/axis_motion.h>

namespace tws {

/// One coordinate of one track in a FixedGainFilter.
struct FixedGainState {
  double position = 0.0;
  double velocity = 0.0;
  double acceleration = 0.0;
  int measurements = 0;
};

/// The α, α-β and α-β-γ filters of one coordinate (Henery 1985, section 3.3), and the expanding and fading memory
/// estimators (section 3.2.3), which are the same filters with other gains. It holds constants only; one object serves
/// all tracks.
///
/// A track starts with the gains of expanding memory, so that its first measurements make the best start, and goes over
/// to the filter's own gains as soon as those give a measurement more weight. That assumes even intervals; uneven ones
/// are taken by β/T and γ/T² as they come.
class FixedGainFilter {
 public:
  using State = FixedGainState;

  /// With these gains for ever. Throws std::invalid_argument unless they are stable.
  static FixedGainFilter withGains(const FilterGains& gains);
  /// With the steady gains of Kalata's tracking index, taken anew from the noise at each update.
  static FixedGainFilter byTrackingIndex(int degree);
  /// Never forgets. The three throw std::invalid_argument unless degree is 0, 1 or 2.
  static FixedGainFilter expandingMemory(int degree);
  /// Throws unless theta is in [0, 1).
  static FixedGainFilter fadingMemory(int degree, double theta);

  State start(double position, const AxisNoise& /*noise*/) const { return {position, 0.0, 0.0, 1}; }

  static AxisMotion motion(const State& state) { return {state.position, state.velocity, state.acceleration}; }

  /// Takes in a measurement dt [s] after the last one. `innovation` is measured minus moved(motion(state),
  /// dt).position; for an azimuth the caller wraps it. dt = 0 changes nothing. Throws std::invalid_argument, and
  /// changes nothing, when dt is negative or either number is not finite.
  void update(State& state, double innovation, double dt, const AxisNoise& noise) const;

  /// The gains of the n-th measurement, counted from 1.
  FilterGains gainsAt(int n, double dt, const AxisNoise& noise) const;

 private:
  FixedGainFilter(int degree, const FilterGains& gains, bool by_index);

  int degree_;
  FilterGains steady_;  // 0: none, or by_index_
  bool by_index_;
};

}  // namespace tws
