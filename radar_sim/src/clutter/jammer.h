#pragma once

#include "clutter/clutter_reading.h"

namespace radar_sim {

/// A noise jammer: a strobe of false plots in its direction, and with enough power all round through the side lobes.
struct Jammer : ClutterSpec {
  Eigen::Vector2d place{0.0, 0.0};     ///< At `from` [m].
  Eigen::Vector2d velocity{0.0, 0.0};  ///< [m/s]
  double height = 8000.0;              ///< Above the sea [m].
  double power = 1000.0;               ///< Effectively radiated [W] ...
  double bandwidth = 100e6;            ///< ... evenly over this [Hz].
  double side_lobes = 1e-4;            ///< Of the radar's antenna in azimuth, power ratio.
  double on = kLongest, off = 0.0;     ///< It blinks so [s].

  std::unique_ptr<Clutter> seenBy(const ClutterView& view) const override;
  std::vector<Eigen::Vector2d> outlineAt(double time) const override { return {placeAt(time)}; }
  Eigen::Vector2d placeAt(double time) const { return place + velocity * (time - from); }
  bool isOnAt(double time) const;
};

/// Its power in the receiver in units of the noise's, with the beam's peak in azimuth on it: Skolnik's one-way
/// equation, P/B G λ² / ((4π R)² k T0 Fn), 0 beyond the horizon. `height` above the sea [m].
double jammerToNoise(const RadarParams& radar, const Jammer& jammer, double slant_range);

std::unique_ptr<ClutterSpec> readJammer(ParameterReader& reader, const ReadingContext& context);

}  // namespace radar_sim
