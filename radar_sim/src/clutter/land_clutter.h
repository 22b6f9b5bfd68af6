#pragma once

#include "clutter/clutter_reading.h"

namespace radar_sim {

/// Land within an area: hills, woods, houses, which stay where they are.
struct LandClutter : ClutterSpec {
  Area area;
  double gamma = 0.03;        ///< Reflectivity by the sine of the grazing angle, a power ratio: σ0 = γ sin ψ.
  double height = 50.0;       ///< Of what reflects, above the sea [m]: how far it is seen over the horizon.
  double steady_share = 0.7;  ///< Of the power: rocks and houses, not leaves.
  TextureParams texture{8.0, 500.0, std::numeric_limits<double>::infinity()};

  std::unique_ptr<Clutter> seenBy(const ClutterView& view) const override;
  std::vector<Eigen::Vector2d> outlineAt(double) const override { return area.outline(); }
};

std::unique_ptr<ClutterSpec> readLandClutter(ParameterReader& reader, const ReadingContext& context);

}  // namespace radar_sim
