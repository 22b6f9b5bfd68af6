#pragma once

#include <cstddef>
#include <string>

#include <tws_core/axis_filter.h>
#include <tws_core/units.h>

namespace range_gate_tracker {

/// What is done with the plots in a window (Henery 1985, section 2.5.1).
enum class Ambiguity {
  kCentreOfGravity,  ///< Their mean place, weighted by amplitude where all signal-to-noise ratios are known.
  kNearest,          ///< The one nearest to the middle of the window.
};

/// What is done with a plot in the tracking windows of two tracks (the same section).
enum class Overlap {
  kMomentum,  ///< Nobody takes it: the filters carry both tracks on until their windows part.
  kShare,     ///< Both take it.
};

/// Parameters of the track-while-scan windows.
struct WindowParams {
  tws::AxisFilterParams filter;
  bool cartesian = true;  ///< Filter x and y; false: range and azimuth, with the pass-course effect (section 3.2.2).

  double greatest_speed = 350.0;             ///< Of the worst manoeuvre in a scan [m/s], > 0.
  double greatest_acceleration = 15.0;       ///< The same [m/s²], >= 0.
  double manoeuvre = 5.0;                    ///< Standard deviation of the acceleration, for the filters [m/s²], > 0.
  double range_sigma = 100.0;                ///< Of a detection that does not say it [m], > 0.
  double azimuth_sigma = tws::radians(0.3);  ///< The same [rad], > 0.
  double window_sigmas = 3.0;                ///< Half a tracking window, in prediction errors, > 0.
  double error_weight = 0.3;                 ///< Of the latest squared error in their mean, (0, 1].
  double widest = tws::radians(60.0);        ///< Half the width of any window, at most [rad], (0, 90°].
  Ambiguity ambiguity = Ambiguity::kCentreOfGravity;
  Overlap overlap = Overlap::kMomentum;

  bool automatic = true;         ///< Every detection outside all windows starts a track.
  int firm_hits = 4;             ///< A track with so many detections may become firm, >= 2.
  int acquisition_scans = 2;     ///< Scans that an acquisition window stays without a detection, >= 1.
  int missed_scans = 4;          ///< A firm track is dropped after so many scans without one, >= 1.
  std::size_t capacity = 10000;  ///< Track numbers, of which one always stays unused, >= 2.

  double least_speed = 10.0;   ///< A target that moves more slowly is stationary [m/s], >= 0.
  double air_speed = 40.0;     ///< One that is faster is an aircraft [m/s], >= least_speed.
  double urgent_time = 180.0;  ///< A closing aircraft that could be at the radar sooner has priority 1 [s], >= 0.
  double period = 6.0;         ///< Of a turn, until the sectors tell [s], > 0.
};

/// Throws std::invalid_argument that names the first parameter out of range, its value and the range.
void check(const WindowParams& params);

}  // namespace range_gate_tracker
