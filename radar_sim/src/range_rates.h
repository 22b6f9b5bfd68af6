#pragma once

#include <Eigen/Geometry>

#include "radar_params.h"
#include "random_stream.h"

namespace radar_sim {

/// How what reflects moves.
struct Motion {
  Eigen::Vector3d velocity{0.0, 0.0, 0.0};  ///< In the map frame [m/s].
  double spread = 0.0;                      ///< Of the radial velocity within, standard deviation [m/s].
};

/// The radial velocity, positive outbound, of what moves so in a direction from the site (unit vector in its axes).
inline double radialVelocity(const Eigen::Isometry3d& map_to_site, const Motion& motion,
                             const Eigen::Vector3d& direction) {
  return direction.dot(map_to_site.linear() * motion.velocity);
}

/// As a radar tells it: of all values that differ by multiples of its ambiguity, the one next to 0.
double folded(const RadarParams& radar, double rate);

/// What a radar that measures range rates measures of a radial velocity with that spread [m/s].
double drawRangeRate(const RadarParams& radar, double rate, double spread, RandomStream& random);

/// The same of noise: any rate within its span.
double drawFalseRangeRate(const RadarParams& radar, RandomStream& random);

}  // namespace radar_sim
