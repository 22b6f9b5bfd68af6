#pragma once

#include <Eigen/Core>
#include <vector>

namespace radar_sim {

/// Where on the map something is: within a polygon, or everywhere.
class Area {
 public:
  Area() = default;
  /// Corners in their order, three at least; east, north [m].
  explicit Area(std::vector<Eigen::Vector2d> corners) : corners_(std::move(corners)) {}

  bool contains(const Eigen::Vector2d& place) const;
  bool isEverywhere() const { return corners_.empty(); }
  /// Points evenly along the border, the corners among them; none: it is everywhere.
  std::vector<Eigen::Vector2d> outline() const;

 private:
  std::vector<Eigen::Vector2d> corners_;
};

/// Points on a circle.
std::vector<Eigen::Vector2d> circle(const Eigen::Vector2d& centre, double radius);

}  // namespace radar_sim
