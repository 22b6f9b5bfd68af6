#pragma once

#include "clutter/clutter_reading.h"

namespace radar_sim {

/// Birds, or swarms of insects: each flies straight on for a while; then another one appears elsewhere.
struct Angels : ClutterSpec {
  Eigen::Vector2d centre{0.0, 0.0};   ///< [m]
  double radius = 20e3;               ///< They appear within this, evenly over the area [m].
  long count = 30;                    ///< At a time.
  Interval speed{8.0, 20.0};          ///< [m/s]
  Interval course{0.0, tws::kTwoPi};  ///< [rad]
  Interval height{50.0, 600.0};       ///< Above the sea [m].
  Interval rcs{0.003, 0.1};           ///< Mean, drawn evenly in decibels [m²].
  double life = 120.0;                ///< [s]

  std::unique_ptr<Clutter> seenBy(const ClutterView& view) const override;
  std::vector<Eigen::Vector2d> outlineAt(double) const override { return circle(centre, radius); }
};

std::unique_ptr<ClutterSpec> readAngels(ParameterReader& reader, const ReadingContext& context);

}  // namespace radar_sim
