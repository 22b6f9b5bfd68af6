#pragma once

#include <cmath>

namespace tws {

constexpr double kPi = 3.14159265358979323846;
constexpr double kTwoPi = 2.0 * kPi;

/// The same direction in [0, 2π); never 2π itself, not even for -1e-17. NaN and infinities give NaN.
inline double wrapTwoPi(double angle) {
  if (angle >= 0.0 && angle < kTwoPi) return angle;
  double wrapped = std::abs(angle) < 2.0 * kTwoPi ? angle : std::fmod(angle, kTwoPi);
  if (wrapped < 0.0) wrapped += kTwoPi;
  if (wrapped < 0.0) wrapped += kTwoPi;
  // A tiny negative angle rounds to 2π when 2π is added; what is a whole turn is north.
  return wrapped >= kTwoPi ? wrapped - kTwoPi : wrapped;
}

/// The same direction in (-π, π]. NaN and infinities give NaN.
inline double wrapPi(double angle) {
  if (angle > -kPi && angle <= kPi) return angle;
  // Exact, in [-π, π]; the difference of two azimuths is within a turn of that, where a subtraction is exact, too.
  const double turned = angle > 0.0 ? angle - kTwoPi : angle + kTwoPi;
  const double wrapped = std::abs(turned) <= kPi ? turned : std::remainder(angle, kTwoPi);
  return wrapped <= -kPi ? kPi : wrapped;
}

/// The turn from b to a, in (-π, π], positive clockwise for azimuths.
inline double angularDifference(double a, double b) { return wrapPi(a - b); }

}  // namespace tws
