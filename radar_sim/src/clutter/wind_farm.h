#pragma once

#include "clutter/clutter_reading.h"

namespace radar_sim {

/// Wind turbines in rows. What turns passes the radar's Doppler filters; a blade that stands upright or straight down
/// flashes, and the beam sees a flash when it comes by just then: by the beat of rotor and antenna.
struct WindFarm : ClutterSpec {
  Eigen::Vector2d centre{0.0, 0.0};  ///< [m]
  long rows = 4, columns = 5;
  double spacing = 700.0;     ///< [m]
  double orientation = 0.0;   ///< Azimuth of the columns [rad].
  double hub_height = 100.0;  ///< Above the sea [m].
  double blade = 60.0;        ///< Length [m]; echoes wander over half of it.
  double rcs = 20.0;          ///< Of what turns, between flashes [m²].
  double flash_rcs = 1000.0;  ///< [m²]
  double rotor_period = 5.0;  ///< [s]; each turbine's lies within a tenth of it.

  std::unique_ptr<Clutter> seenBy(const ClutterView& view) const override;
  std::vector<Eigen::Vector2d> outlineAt(double) const override;
};

std::unique_ptr<ClutterSpec> readWindFarm(ParameterReader& reader, const ReadingContext& context);

}  // namespace radar_sim
