#include "planar_frame.h"

#include <cmath>

namespace tws_rviz {

Eigen::Vector2d PlanarFrame::rotated(const Eigen::Vector2d& vector) const {
  const double c = std::cos(turn);
  const double s = std::sin(turn);
  // Clockwise: what points north (0, 1) then points to azimuth `turn`.
  return {c * vector.x() + s * vector.y(), c * vector.y() - s * vector.x()};
}

}  // namespace tws_rviz
