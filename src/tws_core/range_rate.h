#pragma once

#include <cmath>
#include <limits>

#include <tws_core/turning_motion.h>

namespace tws {

/// What a radar measures by Doppler: how fast the slant range of a target changes. Known or not, and then perhaps but
/// for multiples of twice the radar's unambiguous velocity.
struct RangeRate {
  double value = std::numeric_limits<double>::quiet_NaN();  // positive outbound [m/s]; NaN: not measured
  double sigma = 1.0;                                       // standard deviation [m/s], > 0
  double ambiguity = 0.0;  // the value is known but for multiples of this [m/s]; 0: it is known
  // The radar's place on the plane [m], and the target's height above it, squared, with variance [m²], [m⁴]; 0: the
  // plane's distances are slant ranges.
  double x = 0.0, y = 0.0;
  double squared_height = 0.0, squared_height_variance = 0.0;

  bool known() const { return !std::isnan(value); }
  /// The difference of two rates, of all that it may be the smallest.
  double difference(double a, double b) const { return ambiguity > 0.0 ? std::remainder(a - b, ambiguity) : a - b; }
};

/// The range rate of a target that moves so, and how it depends on position and velocity: h = p·v / r, with r the slant
/// range.
struct RangeRatePrediction {
  double value;           // [m/s]
  double x, y, vx, vy;    // its derivatives
  double to_position[2];  // its covariance with x and y [m²/s],
  double to_velocity[2];  // and with vx and vy [m²/s²]
  double variance;        // without the radar's own error [m²/s²]
};

/// Of first order, but for the variance, which holds the product of the errors of direction and of the velocity across:
/// of a new track, neither is known.
RangeRatePrediction predictRangeRate(const PlanarMotion& s, const RangeRate& radar);

/// Is a rate known to that variance [m²/s²], together with the radar's error, of use? Not where it may be one of
/// several folds.
inline bool tellsFold(double variance, const RangeRate& z) {
  constexpr double kSigmas = 4.0;
  return z.ambiguity == 0.0 || variance * kSigmas * kSigmas < z.ambiguity * z.ambiguity;
}

/// Here the density of the fit is a whole one [s/m], without the 2π of a position's. Where the fold cannot be told, all
/// of them are alike likely, and nothing is learned.
MeasurementFit fitOf(const PlanarMotion& s, const RangeRate& z);

/// Kalman update with a range rate.
MeasurementFit correct(TurningMotion& s, const RangeRate& z);

}  // namespace tws
