#include <tws_core/refraction.h>

#include <algorithm>
#include <cmath>

namespace tws {

// The triangle earth centre, antenna, target: (a + ht)² = (a + ha)² + R² + 2 (a + ha) R sin(elevation).
double sineOfElevation(double antenna_height, double target_height, double slant_range, double earth_radius) {
  const double to_antenna = earth_radius + antenna_height;
  const double rise = target_height - antenna_height;
  const double sine = (rise * (2.0 * to_antenna + rise) - slant_range * slant_range) / (2.0 * to_antenna * slant_range);
  return std::clamp(sine, -1.0, 1.0);
}

// The same solved for the rise; the root of a sum less one of its terms, without the loss of digits.
double heightOf(double antenna_height, double sine_of_elevation, double slant_range, double earth_radius) {
  const double to_antenna = earth_radius + antenna_height;
  const double more = slant_range * (slant_range + 2.0 * to_antenna * sine_of_elevation);
  return antenna_height + more / (to_antenna + std::sqrt(std::max(to_antenna * to_antenna + more, 0.0)));
}

// Simpson's rule. The refractivity bends over kilometres, a step is 1/32 of the way: right to a millimetre for
// aircraft.
double airDelay(double antenna_height, double target_height, double slant_range) {
  constexpr double kAtSea = 315e-6, kScaleHeight = 7350.0;
  constexpr int kSteps = 32;
  const double sine = sineOfElevation(antenna_height, target_height, slant_range);
  double sum = 0.0;
  for (int i = 0; i <= kSteps; ++i) {
    const double height = heightOf(antenna_height, sine, slant_range * i / kSteps);
    const double weight = i == 0 || i == kSteps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0;
    sum += weight * kAtSea * std::exp(-std::max(height, 0.0) / kScaleHeight);
  }
  return sum * slant_range / (3.0 * kSteps);
}

}  // namespace tws
