#include "registration_errors.h"

#include <cmath>

#include <tws_core/refraction.h>

namespace radar_sim {

double AzimuthErrors::at(double azimuth, double elapsed) const {
  return bias + eccentricity * std::sin(azimuth + eccentricity_phase) + north_drift * elapsed;
}

double RegistrationErrors::delayOf(double antenna_height, double target_height, double slant_range) const {
  return air_delays ? tws::airDelay(antenna_height, target_height, slant_range) : 0.0;
}

// About the horizontal line across the direction to which the axis leans: the antenna dips there, and what stands there
// appears higher.
Eigen::Isometry3d RegistrationErrors::toAntenna(const Eigen::Isometry3d& map_to_site) const {
  if (tilt == 0.0) return map_to_site;
  const Eigen::Vector3d across(std::cos(tilt_azimuth), -std::sin(tilt_azimuth), 0.0);
  return Eigen::AngleAxisd(tilt, across) * map_to_site;
}

}  // namespace radar_sim
