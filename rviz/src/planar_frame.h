#pragma once

#include <Eigen/Core>

namespace tws_rviz {

/// Where a frame lies in the picture's frame, seen from above: all that a PPI needs of a transform.
struct PlanarFrame {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  // in the picture [m]
  double turn = 0.0;                                 // azimuth in the picture of the frame's own north [rad], clockwise

  /// A vector of the frame in the picture's directions.
  Eigen::Vector2d rotated(const Eigen::Vector2d& vector) const;
  /// A place of the frame [m] in the picture [m].
  Eigen::Vector2d placed(const Eigen::Vector2d& position) const { return origin + rotated(position); }
};

}  // namespace tws_rviz
