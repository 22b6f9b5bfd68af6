#pragma once

#include <Eigen/Core>
#include <vector>

namespace radar_sim {

/// Where a target is and how it moves, in the scenario's map frame (east, north, up).
struct TargetState {
  Eigen::Vector3d position;  ///< [m]
  Eigen::Vector3d velocity;  ///< [m/s]
  double height;             ///< Above the sea [m]; differs from position.z() by the earth's curvature.
};

/// From `start` up to, not including, `end` [s of data time].
struct TimeSpan {
  double start;
  double end;
};

/// The motion of one target. It exists during one or more spans: a recording may have gaps.
class Trajectory {
 public:
  virtual ~Trajectory() = default;
  /// Must only be asked at times when the target exists.
  virtual TargetState at(double time) const = 0;

  bool existsAt(double time) const { return nextExistence(time) == time; }
  /// The earliest time from `time` on at which the target exists; infinity: never again.
  double nextExistence(double time) const;
  const std::vector<TimeSpan>& spans() const { return spans_; }

 protected:
  /// In order of time, not overlapping.
  explicit Trajectory(std::vector<TimeSpan> spans) : spans_(std::move(spans)) {}

 private:
  std::vector<TimeSpan> spans_;
};

/// A point of the map frame at `height` above the sea, on a spherical earth whose sea level lies `origin_altitude` [m]
/// below the map's origin: far from the origin, constant height sinks below the map's plane.
TargetState overTheSea(const Eigen::Vector2d& position, const Eigen::Vector2d& velocity, double height,
                       double climb_rate, double origin_altitude);

}  // namespace radar_sim
