#pragma once

#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/units.h>

namespace tws {

/// Least significant bits of NRL Report 7952. The angles are the exact binary fractions of a turn that the report
/// prints as 0.010986° and 0.000244 °/s.
constexpr double kRangeLsb = 62.5 * kMetresPerFoot;      // [m]
constexpr double kAzimuthLsb = kTwoPi / 32768.0;         // [rad]
constexpr double kRangeRateLsb = 0.25 * kMetresPerFoot;  // [m/s]
constexpr double kAzimuthRateLsb = kAzimuthLsb / 45.0;   // [rad/s]
constexpr double kTimeLsb = 0.008;                       // [s]

/// The multiple of `lsb` nearest to `value`, halves to the even multiple; `lsb` 0 leaves the value as it is.
inline double quantise(double value, double lsb) { return lsb > 0.0 ? std::nearbyint(value / lsb) * lsb : value; }

}  // namespace tws
