#pragma once

#include <array>

#include <tws_core/axis_motion.h>

namespace tws {

/// One coordinate of one track in a FixedMemoryFilter.
struct FixedMemoryState {
  static constexpr int kMost = 16;

  AxisMotion motion;                     // at the last measurement
  int measurements = 0;                  // kept below, newest first
  std::array<double, kMost> position{};  // measured
  std::array<double, kMost> time{};      // [s], 0 at the newest one
};

/// Fixed memory (Henery 1985, section 3.2.3; Morrison 1969): the least-squares polynomial through the last
/// measurements, all of equal weight, at whatever times they were made. It holds constants only; one object serves all
/// tracks.
class FixedMemoryFilter {
 public:
  using State = FixedMemoryState;

  /// Throws std::invalid_argument unless degree is 0, 1 or 2 and length in [degree + 1, 16] measurements.
  FixedMemoryFilter(int degree, int length);

  State start(double position, const AxisNoise& noise) const;
  static AxisMotion motion(const State& state) { return state.motion; }
  /// As FixedGainFilter::update().
  void update(State& state, double innovation, double dt, const AxisNoise& noise) const;

 private:
  void remember(State& state, double measured, double dt) const;

  int degree_;
  int length_;
};

}  // namespace tws
