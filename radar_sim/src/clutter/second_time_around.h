#pragma once

#include "clutter/clutter_reading.h"

namespace radar_sim {

/// Mountains beyond the unambiguous range, whose echoes come after the next pulse: a ring of clutter where nothing is.
struct SecondTimeAround : ClutterSpec {
  double unambiguous_range = 150e3;    ///< c/2 times the pulse interval [m]: by so much they seem nearer.
  Interval range{160e3, 220e3};        ///< Where they are [m].
  Interval azimuth{0.0, tws::kTwoPi};  ///< From the first clockwise to the second [rad].
  double reflectivity = 0.01;          ///< σ0, a power ratio.
  double height = 2000.0;              ///< Above the sea [m].
  double steady_share = 0.5;           ///< Of the power.
  TextureParams texture{8.0, 2000.0, std::numeric_limits<double>::infinity()};

  std::unique_ptr<Clutter> seenBy(const ClutterView& view) const override;
  /// It lies round each radar by itself.
  std::vector<Eigen::Vector2d> outlineAt(double) const override { return {}; }
};

std::unique_ptr<ClutterSpec> readSecondTimeAround(ParameterReader& reader, const ReadingContext& context);

}  // namespace radar_sim
