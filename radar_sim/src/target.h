#pragma once

#include <limits>
#include <memory>
#include <string>

#include "detection_probability.h"
#include "trajectory.h"
#include "transponder.h"

namespace radar_sim {

enum class TargetKind { kAircraft, kShip, kClutter, kSlowMover };

/// How a target reflects.
struct Reflection {
  double rcs = 5.0;  ///< Mean radar cross-section [m²].
  Fluctuation fluctuation = Fluctuation::kExponential;
  /// Chance of detection on one scan, in place of the radar equation (for clutter, whose path to the radar no equation
  /// knows). NaN: by the radar equation.
  double detection_probability = std::numeric_limits<double>::quiet_NaN();
  /// The echo's centre wanders from scan to scan by this standard deviation in range and across [m].
  double jitter = 0.0;
};

/// What a radar of high range resolution sees of a target.
struct Body {
  double length = 0.0;       ///< Along the course [m].
  long scatterers = 1;       ///< Evenly drawn over the length, each with its share of the cross-section.
  double fading_time = 0.1;  ///< In which a scatterer's fluctuation falls to 1/e [s]; of Swerling 1 and 3.
};

/// One thing that echoes. The name is unique and keys its random numbers.
struct Target {
  std::string name;
  TargetKind kind = TargetKind::kAircraft;
  Reflection reflection;
  std::shared_ptr<const Trajectory> trajectory;
  Transponder transponder;
  Body body = {};
};

}  // namespace radar_sim
