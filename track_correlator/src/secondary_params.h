#pragma once

#include <tws_core/units.h>

namespace track_correlator {

/// Constants of the secondary tracker. The paper gives none of them.
struct SecondaryParams {
  int delay_sectors = 2;                      ///< Sectors behind the antenna (Δ₁), 2 .. 32.
  double range_sigma = 50.0;                  ///< Standard deviation of the plots [m], > 0,
  double azimuth_sigma = tws::radians(0.1);   ///< and of their azimuths [rad], > 0.
  double acceleration_density = 20.0;         ///< White acceleration of the aircraft [m²/s³], >= 0.
  double speed_sigma = 200.0;                 ///< Of each velocity component of a new track [m/s], > 0.
  double gate = 16.0;                         ///< Greatest normalised innovation squared of a match by position.
  double code_gate = 5000.0;                  ///< Greatest distance of a match by unique code [m].
  double unknown_code_cost = 3.0;             ///< Added to the innovation of a pair whose codes say nothing,
  double different_code_cost = 9.0;           ///< and of one whose codes differ.
  double garble_range = 3050.0;               ///< Closer than this in range [m], the length of a reply of 20.3 µs,
  double garble_azimuth = tws::radians(3.0);  ///< and than this in azimuth [rad], replies overlap.
  int code_change_replies = 3;                ///< Clean replies in a row that change a track's code.
  double climb_limit = 75.0;                  ///< Fastest climb or descent accepted [m/s].
  double split_distance = 500.0;              ///< A second plot so near with the same code is no aircraft [m].
  int confirm_plots = 3;                      ///< Plots that make a track firm.
  int tentative_misses = 2;                   ///< Scans in a row without a plot that drop a tentative track,
  int drop_misses = 5;                        ///< and a firm one.
};

}  // namespace track_correlator
