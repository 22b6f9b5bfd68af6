#pragma once

#include <limits>

#include <tws_core/angles.h>

namespace adit_tracker {

/// A part of the sky, or of the clutter on the ground, as the site of the tracker's first radar sees it.
struct VolumePlace {
  double range = 0.0, azimuth = 0.0;                         // [m], [rad], as in Kinematics
  double height = std::numeric_limits<double>::quiet_NaN();  // above the antenna [m]; NaN: unknown
};

/// Ranges of range, azimuth and height; all of them, unless it is told otherwise. Limits belong to it.
struct VolumeRegion {
  double least_range = 0.0, greatest_range = std::numeric_limits<double>::infinity();  // [m]
  double first_azimuth = 0.0;                                                          // [rad], [0, 2π)
  double azimuths = tws::kTwoPi;                                     // how far on clockwise [rad], (0, 2π]
  double least_height = -std::numeric_limits<double>::infinity();    // [m]
  double greatest_height = std::numeric_limits<double>::infinity();  // [m]
  bool holds_unknown_height = true;

  /// Also what is off by `margin` [m] across a limit of range or azimuth, or by a tenth of it in height.
  bool contains(const VolumePlace& place, double margin = 0.0) const;
};

}  // namespace adit_tracker
