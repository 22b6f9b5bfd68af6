#include "propagation.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace radar_sim {

double horizonDistance(double height) { return std::sqrt(2.0 * kEffectiveEarthRadius * std::max(height, 0.0)); }

// The triangle earth centre, antenna, target: (a + ht)² = (a + ha)² + R² + 2 (a + ha) R sin(elevation).
double sineOfElevation(double antenna_height, double target_height, double slant_range) {
  const double to_antenna = kEffectiveEarthRadius + antenna_height;
  const double rise = target_height - antenna_height;
  const double sine = (rise * (2.0 * to_antenna + rise) - slant_range * slant_range) / (2.0 * to_antenna * slant_range);
  return std::clamp(sine, -1.0, 1.0);
}

bool isBeyondHorizon(double antenna_height, double target_height, double slant_range) {
  return slant_range > horizonDistance(antenna_height) + horizonDistance(target_height);
}

double propagationFactor(double antenna_height, double wavelength, double sine_of_elevation, double direct_gain,
                         double reflected_gain, double reflection) {
  // Below the horizontal, just before the horizon, the two rays have merged: the phase is held at its value for the
  // horizontal.
  const double path_difference = 2.0 * antenna_height * std::max(sine_of_elevation, 0.0);
  const double reflected = reflection * reflected_gain;
  return direct_gain * direct_gain + reflected * reflected -
         2.0 * direct_gain * reflected * std::cos(tws::kTwoPi * path_difference / wavelength);
}

}  // namespace radar_sim
