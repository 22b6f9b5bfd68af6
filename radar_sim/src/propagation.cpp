#include "propagation.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace radar_sim {

double horizonDistance(double height) { return std::sqrt(2.0 * kEffectiveEarthRadius * std::max(height, 0.0)); }

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
