#include "trajectory.h"

#include <cmath>
#include <limits>

#include "propagation.h"

namespace radar_sim {

double Trajectory::nextExistence(double time) const {
  for (const TimeSpan& span : spans_) {
    if (time < span.end) return std::max(time, span.start);
  }
  return std::numeric_limits<double>::infinity();
}

TargetState overTheSea(const Eigen::Vector2d& position, const Eigen::Vector2d& velocity, double height,
                       double climb_rate, double origin_altitude) {
  // On the sphere: (z + a + h0)² + d² = (a + h)².
  const double radius = tws::kMeanEarthRadius + height;
  const double to_centre = std::sqrt(radius * radius - position.squaredNorm());
  const double sinking = (radius * climb_rate - position.dot(velocity)) / to_centre;
  TargetState state;
  state.position << position, to_centre - tws::kMeanEarthRadius - origin_altitude;
  state.velocity << velocity, sinking;
  state.height = height;
  return state;
}

}  // namespace radar_sim
