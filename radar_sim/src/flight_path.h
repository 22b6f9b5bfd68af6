#pragma once

#include <limits>
#include <vector>

#include "trajectory.h"

namespace radar_sim {

/// Motion of a leg, all constant: straight and level when left alone.
struct Leg {
  double duration = 0.0;      ///< [s]
  double turn_rate = 0.0;     ///< Clockwise positive [rad/s]; 0, or at least 1e-6 in magnitude.
  double acceleration = 0.0;  ///< Along the path [m/s²].
  double climb_rate = 0.0;    ///< [m/s]
};

/// Where a flight path begins.
struct PathStart {
  double time = 0.0;                   ///< [s of data time]
  Eigen::Vector2d position{0.0, 0.0};  ///< East, north [m].
  double height = 0.0;                 ///< Above the sea [m].
  double course = 0.0;                 ///< Clockwise from north [rad].
  double speed = 0.0;                  ///< Over ground [m/s].
};

struct Waypoint {
  Eigen::Vector2d position;  ///< East, north [m].
  double height;             ///< Above the sea [m].
  double speed;              ///< Over ground [m/s], > 0.
};

/// A chain of legs in closed form; after the last one it goes on straight and level, up to 5000 km from the origin.
class FlightPath : public Trajectory {
 public:
  /// `origin_altitude`: of the map's origin above the sea [m]. `end`: the target is gone from then on [s of data time].
  /// Throws std::invalid_argument when a leg makes the speed negative.
  FlightPath(const PathStart& start, const std::vector<Leg>& legs, double origin_altitude,
             double end = std::numeric_limits<double>::infinity());

  TargetState at(double time) const override;

  /// From when on [s of data time] it stays farther than `radius` [m] from `centre` (east, north), after its last leg;
  /// infinity: it never does.
  double leavesForGood(const Eigen::Vector2d& centre, double radius) const;

 private:
  struct Segment {
    PathStart start;
    Leg leg;
  };
  using Segments = std::vector<Segment>;

  static Segments chain(const PathStart& start, const std::vector<Leg>& legs);
  static double leavesForGood(const PathStart& straight, const Eigen::Vector2d& centre, double radius);
  FlightPath(Segments segments, double origin_altitude, double end);

  Segments segments_;
  double origin_altitude_;
};

/// Legs that fly over each waypoint in turn, from the first one on, with speed and height reached at the next one.
/// After each it turns the shorter way at `turn_rate` [rad/s, > 0] until the next lies ahead. `start` receives where
/// the path begins. Throws std::invalid_argument when a waypoint lies inside the turning circle, or when there are
/// fewer than two.
std::vector<Leg> legsThrough(const std::vector<Waypoint>& waypoints, double turn_rate, PathStart& start);

}  // namespace radar_sim
