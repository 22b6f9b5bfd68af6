#pragma once

#include "clutter/clutter_reading.h"

namespace radar_sim {

/// The sea's surface within an area.
struct SeaClutter : ClutterSpec {
  Area area;
  double sea_state = 3.0;  ///< Of Douglas, 0 .. 6.
  double wind_from = 0.0;  ///< Azimuth from which the wind blows [rad].
  TextureParams texture{4.0, 300.0, 10.0};

  std::unique_ptr<Clutter> seenBy(const ClutterView& view) const override;
  std::vector<Eigen::Vector2d> outlineAt(double) const override { return area.outline(); }
};

/// Mean reflectivity [m²/m²] of the sea at horizontal polarisation: the empirical fit of Gregers-Hansen and Mittal, "An
/// improved empirical model for radar sea clutter reflectivity", NRL/MR/5310-12-9346, 2012; for 0.5 to 35 GHz and 0.1
/// to 60° (below, it is continued). `grazing` > 0 [rad].
double seaReflectivity(double wavelength, double sea_state, double grazing);

/// How fast the scatterers of the sea move before the wind [m/s]: a fifth of its speed, of which the sea state is the
/// measure, 3.16 s^0.8 m/s (orders of magnitude as in Nathanson, Radar Design Principles; not fitted to data).
double driftOfSea(double sea_state);

/// Power ratio by which it is stronger looking so far away from upwind [rad]: exp(0.2 cos φ (1 - 2.8 ψ) (λ +
/// 0.015)^-0.4) (Horst, Dyer and Tuley, "Radar sea clutter model", IEE conference publication 169, 1978).
double upwindFactor(double wavelength, double grazing, double from_upwind);

std::unique_ptr<ClutterSpec> readSeaClutter(ParameterReader& reader, const ReadingContext& context);

}  // namespace radar_sim
