#pragma once

#include <tws_core/planar_gaussian.h>

namespace tws {

/// Gaussian of position, velocity and turn rate (anticlockwise positive [rad/s]). With a rate variance of 0 the rate is
/// given, 0 is straight flight; otherwise it is estimated with the rest.
struct TurningMotion : PlanarMotion {
  double rate = 0.0, rate_variance = 0.0;
  double x_rate = 0.0, y_rate = 0.0, vx_rate = 0.0, vy_rate = 0.0;  // Covariances with the rate.
};

/// Moves it on by dt [s] ≥ 0 with white acceleration of this density [m²/s³]: exact in the turn, of first order in the
/// error of its rate (coordinated turn with an unknown rate, Bar-Shalom, Li & Kirubarajan, "Estimation with
/// Applications to Tracking and Navigation", section 11.7.1).
void advance(TurningMotion& s, double dt, double density);

/// Its position after that alone, at less cost.
PlanarPosition advancedPosition(const TurningMotion& s, double dt, double density);

/// A measurement's likelihood is density · exp(-squared_distance / 2) / 2π.
struct MeasurementFit {
  double squared_distance, density;
};

/// Kalman update with a position.
MeasurementFit correct(TurningMotion& s, const PlanarPosition& measurement);

/// One Gaussian in place of several, in two passes: first the means, each with its weight (they add up to 1), then
/// the covariances, which hold the spread of those means about the common one.
void addMean(PlanarMotion& to, const PlanarMotion& from, double weight);
void addMean(TurningMotion& to, const TurningMotion& from, double weight);
void addSpread(PlanarMotion& to, const PlanarMotion& from, double weight);
void addSpread(TurningMotion& to, const TurningMotion& from, double weight);

}  // namespace tws
