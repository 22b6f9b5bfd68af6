#pragma once

#include <string>

#include <tws_core/units.h>

namespace adit_tracker {

/// Elevation searches by a 3-D radar (ELEV), and the heights that come of them.
struct ElevationParams {
  std::string radar;                // Which radar searches. Empty: the reference radar (the report's SPS-39).
  long per_scan = 8;                // Most searches on one scan of it.
  long new_per_scan = 4;            // Of these, most for targets designated since the scan before (NDESTAR).
  long every_scans = 4;             // A designated target is searched on every so many scans of the radar (TF).
  double lead = tws::radians(3.0);  // A search begins so far before the predicted azimuth [rad].
  bool automatic = false;           // Every firm track is designated.

  // Heights, from elevations that plots bear.
  double sigma = tws::radians(0.2);  // Standard deviation of an elevation where the plot does not say [rad].
  double climb_sigma = 10.0;         // Standard deviation of the climb rate before it is known [m/s].
  double climb_acceleration = 0.5;   // White acceleration density in height [m²/s³].
  double gate_sigmas = 5.0;          // A height further off than so many standard deviations begins anew.
  double greatest_sigma = 2000.0;    // A height more uncertain is not reported any more [m].
};

}  // namespace adit_tracker
