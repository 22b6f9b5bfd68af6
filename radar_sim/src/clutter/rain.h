#pragma once

#include "clutter/clutter_reading.h"

namespace radar_sim {

constexpr double kMillimetrePerHour = 1e-3 / 3600.0;  ///< [m/s]

/// A rain cell that drifts with the wind. The rate falls from its middle on as exp(-d²/radius²).
struct Rain : ClutterSpec {
  Eigen::Vector2d centre{0.0, 0.0};         ///< At `from` [m].
  Eigen::Vector2d velocity{0.0, 0.0};       ///< [m/s]
  double radius = 8000.0;                   ///< [m]
  double rate = 10.0 * kMillimetrePerHour;  ///< In the middle [m/s].
  double top = 4000.0;                      ///< Height up to which it rains [m].
  TextureParams texture;                    ///< Of the reflectivity; it drifts along.

  std::unique_ptr<Clutter> seenBy(const ClutterView& view) const override;
  std::vector<Eigen::Vector2d> outlineAt(double time) const override { return circle(centreAt(time), radius); }
  Eigen::Vector2d centreAt(double time) const { return centre + velocity * (time - from); }
};

/// Volume reflectivity [m²/m³] of rain of that rate [m/s]: η = π⁵ |K|² Z / λ⁴, |K|² = 0.93, with Z = 200 r^1.6 mm⁶/m³
/// and r the rate in mm/h (Marshall and Palmer 1948; Skolnik, Introduction to Radar Systems, 2nd ed., section 13.7).
double rainReflectivity(double rate, double wavelength);

std::unique_ptr<ClutterSpec> readRain(ParameterReader& reader, const ReadingContext& context);

}  // namespace radar_sim
