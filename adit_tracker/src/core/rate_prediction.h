#pragma once

#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/planar_gaussian.h>

namespace adit_tracker {

/// The range rate that the radar whose beam meets a track next will measure, if it measures any.
struct RatePrediction {
  float value = 0.0F;                          // [m/s]
  float variance = 0.0F;                       // of the innovation, the radar's own error included; 0: it measures none
  float with_range = 0.0F, with_cross = 0.0F;  // its covariance with the innovation in range and cross-range [m²/s]
  float manoeuvre = 0.0F;                      // standard deviation that a hard manoeuvre adds [m/s]

  /// Of its variance, so much is left when the plot's place is known, whatever rounding does.
  static constexpr double kLeast = 1e-3;

  bool known() const { return variance > 0.0F; }

  /// Once the plot's place is known.
  struct Expected {
    double shift, variance;  // of the innovation: its mean [m/s], its variance [m²/s²]
  };
  /// `innovation`: covariance of that in range and cross-range [m²].
  Expected given(const tws::Symmetric2& innovation, double by_range, double across) const {
    return given(innovation, static_cast<double>(with_range), static_cast<double>(with_cross),
                 static_cast<double>(variance), by_range, across);
  }
  /// The same in a hard manoeuvre, which adds to range and rate alike. `innovation` holds it, `spread` is the standard
  /// deviation by which [m].
  Expected givenManoeuvre(const tws::Symmetric2& innovation, double spread, double by_range, double across) const {
    const auto faster = static_cast<double>(manoeuvre);
    return given(innovation, static_cast<double>(with_range) + spread * faster, static_cast<double>(with_cross),
                 static_cast<double>(variance) + faster * faster, by_range, across);
  }

 private:
  static Expected given(const tws::Symmetric2& s, double range, double cross, double all, double by_range,
                        double across) {
    const double inverse = 1.0 / s.determinant();
    const double a = (s.yy * range - s.xy * cross) * inverse, b = (s.xx * cross - s.xy * range) * inverse;
    return {a * by_range + b * across, std::fmax(all - a * range - b * cross, kLeast * all)};
  }
};

/// How well a plot's range rate fits the track, where the plot's place is known.
struct RateMatch {
  double squared = 0.0;   // the distance, in standard deviations of the innovation
  double variance = 1.0;  // of that [m²/s²]

  /// How much likelier the rate is of the track's target than of a false plot, whose rates spread over `span` [m/s].
  double likelihood(double span) const { return span * std::exp(-0.5 * squared) / std::sqrt(tws::kTwoPi * variance); }
};

}  // namespace adit_tracker
