#pragma once

#include <string>

#include <tws_core/units.h>

namespace radar_sim {

/// One electronically scanned array that stares in one direction and steers its beam within. Directions in sine space
/// (u to the right of boresight, v above it; tws_core/sine_space.h). Defaults are those of no particular set.
struct ArrayParams {
  std::string name;  ///< Also the topics' first part and the tf frame.
  std::string site;

  // Array face.
  double antenna_height = 25.0;               ///< Above the sea [m].
  double azimuth = 0.0;                       ///< Of boresight, clockwise from true north [rad].
  double tilt = tws::radians(15.0);           ///< Of boresight above the horizontal [rad].
  double beamwidth_u = 0.035;                 ///< Full width at half power, one way, in sine space.
  double beamwidth_v = 0.035;                 ///< [1]
  double greatest_scan = tws::radians(60.0);  ///< The beam is steered no further off boresight [rad].

  // Echo.
  double reference_snr = 20.0;      ///< Of 1 m² on boresight, in the beam's centre at reference_range; power ratio.
  double reference_range = 100e3;   ///< [m]
  double scan_loss_exponent = 3.0;  ///< Two-way power falls as this power of the cosine of the scan angle.
  double false_alarm_probability = 1e-6;  ///< Of one test; sets the threshold.
  double false_alarms_per_dwell = 0.02;   ///< Poisson mean.
  double range_cell = 30.0;               ///< Echoes of one dwell that are closer in range merge [m].
  double min_range = 2000.0;              ///< [m]
  double max_range = 150e3;               ///< [m]
  double range_sigma_floor = 2.0;         ///< Least standard deviation of a measured range [m].
  double angle_sigma_floor = 1e-4;        ///< Least standard deviation of a measured u or v.

  // Time.
  double resource_period = 0.1;  ///< [s]
  double dwell_time = 0.01;      ///< [s]; one resource period holds as many whole dwells as fit.
  double command_latency = 0.1;  ///< From the stamp of a track database until dwells are planned by it [s].

  // Search raster: beams on a grid over this part of sine space.
  double search_u_from = -0.5, search_u_to = 0.5;
  double search_v_from = -0.25, search_v_to = 0.1;
  double search_spacing = 0.75;  ///< Of neighbouring beams [beamwidths].
  double search_share = 0.2;     ///< Least share of each resource period that goes to search, 0 .. 1.

  // Dwells on tracks.
  double revisit_interval = 1.0;  ///< Of tracks whose tracker wants none in particular [s].
  double sequence_spacing = 0.7;  ///< Of the overlapping beams of a sequence [beamwidths].
  double sequence_distance =
      1.0;  ///< Tracks that are closer than this, one to the next, share a sequence [beamwidths].
};

}  // namespace radar_sim
