#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "target.h"

namespace radar_sim {

struct Interval {
  double least;
  double greatest;
};

/// A number of like targets, drawn from uniform distributions. Positions are uniform over the area of a ring round the
/// centre.
struct RandomGroup {
  std::string name;  ///< Its targets are name/slot, or name/slot/life with rebirth.
  TargetKind kind = TargetKind::kAircraft;
  long count = 0;
  Eigen::Vector2d centre{0.0, 0.0};  ///< East, north [m].
  Interval range{10e3, 170e3};       ///< From the centre, at the start [m].
  Interval speed{100.0, 300.0};      ///< [m/s]
  Interval height{1000.0, 12000.0};  ///< Above the sea [m].
  Interval rcs{2.0, 10.0};           ///< [m²]; drawn uniform in decibels.
  Reflection reflection;             ///< All but the radar cross-section.

  TransponderShares transponders;

  // Manoeuvres: straight legs and turns in alternation, for this share of the targets.
  double turning_fraction = 0.0;                 ///< 0 .. 1
  Interval turn_rate{0.0, 0.0};                  ///< Either way [rad/s].
  Interval turn_duration{15.0, 45.0};            ///< [s]
  Interval straight_duration{40.0, 120.0};       ///< [s]
  double greatest_acceleration = 3.0 * 9.80665;  ///< Limits the turn rate of fast ones [m/s²].

  /// A target ends where it leaves `range.greatest`, and another one enters there, bound within 60° of the centre.
  bool rebirth = false;
  /// Paths that come closer to the centre are drawn again [m].
  double keep_out = 0.0;
  /// When the group is there [s of data time].
  TimeSpan life{-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
};

/// The group's targets that live within [start, end] [s of data time]. Each slot and life has its own random stream: a
/// longer run, or a larger count, adds targets and changes none. `origin_altitude`: of the map's origin above the sea
/// [m]. Throws std::invalid_argument when no path satisfies keep_out in a thousand trials.
std::vector<Target> drawGroup(const RandomGroup& group, std::uint64_t seed, double origin_altitude, double start,
                              double end);

}  // namespace radar_sim
