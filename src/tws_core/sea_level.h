#pragma once

#include <tws_core/geodesy.h>

#include <Eigen/Core>
#include <optional>

namespace tws {

/// Heights above mean sea level of points in a map frame (east, north, up [m]), over a curved earth. The geoid is taken
/// for the ellipsoid.
class SeaLevel {
 public:
  /// Where the map lies is not known: it touches a sphere at sea level (altitudeOverSphere).
  SeaLevel() = default;
  /// Throws std::invalid_argument as LocalFrame.
  explicit SeaLevel(const Geodetic& origin) : frame_(LocalFrame(origin)) {}

  /// Above the sea [m]; NaN of NaN.
  double heightOf(const Eigen::Vector3d& point) const;

  /// The z [m] of a point at slant range `range` [m] in the horizontal direction `direction` (a unit vector, x and y of
  /// the map) from `from`, that has this height above the sea [m]; nothing: no point has it.
  std::optional<double> upAtRange(const Eigen::Vector3d& from, const Eigen::Vector2d& direction, double range,
                                  double height) const;

 private:
  std::optional<LocalFrame> frame_;
};

}  // namespace tws
