#pragma once

#include <vector>

#include <tws_core/plot.h>

namespace radar_sim {

/// What crossed the threshold, before the resolution cell and the measurement.
struct Echo {
  double time;                                   ///< The beam is on it [s of data time].
  double range;                                  ///< Without error [m].
  double azimuth;                                ///< Without error [rad].
  double power;                                  ///< In units of the mean noise power.
  double range_error = 0.0;                      ///< Of the measurement [m].
  double azimuth_error = 0.0;                    ///< Of the measurement [rad].
  double elevation = tws::Plot::kUnknown;        ///< As measured [rad]; NaN: not.
  double elevation_sigma = tws::Plot::kUnknown;  ///< Of that [rad].
  double range_rate = tws::Plot::kUnknown;       ///< As measured [m/s]; NaN: not.
};

/// Closes the resolution cells whose first echo comes before `until`, takes their echoes out of `pending` and returns
/// one echo a cell. A cell spans `range_cell` [m] and `azimuth_cell` [rad] from its earliest echo on; its echoes merge
/// at the centre of power, with the errors and the range rate of the strongest. `pending` must be in order of time and
/// complete up to `until` plus the time that the beam takes for `azimuth_cell`.
std::vector<Echo> resolve(std::vector<Echo>& pending, double until, double range_cell, double azimuth_cell);

}  // namespace radar_sim
