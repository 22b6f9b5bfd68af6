#pragma once

#include "clutter/clutter_reading.h"

namespace radar_sim {

/// A duct along the surface: land and sea far beyond the horizon come into view, wax and wane.
struct AnomalousPropagation : ClutterSpec {
  Area area;                   ///< Of the surface that is seen through it.
  double reflectivity = 1e-4;  ///< σ0, a power ratio.
  double steady_share = 0.5;   ///< Of the power.
  TextureParams texture{8.0, 5000.0, 300.0};

  std::unique_ptr<Clutter> seenBy(const ClutterView& view) const override;
  std::vector<Eigen::Vector2d> outlineAt(double) const override { return area.outline(); }
};

std::unique_ptr<ClutterSpec> readAnomalousPropagation(ParameterReader& reader, const ReadingContext& context);

}  // namespace radar_sim
