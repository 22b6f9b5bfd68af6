#pragma once

#include <Eigen/Geometry>

namespace radar_sim {

/// By how much a radar's turning gear overstates the azimuth of its antenna: what it takes for north is not north, its
/// axis is not in the middle of its azimuth circle, and its north creeps.
struct AzimuthErrors {
  double bias = 0.0;                ///< Measured less true [rad].
  double eccentricity = 0.0;        ///< Amplitude of a sine of the azimuth [rad], >= 0.
  double eccentricity_phase = 0.0;  ///< The error is eccentricity * sin(azimuth + eccentricity_phase) [rad].
  double north_drift = 0.0;         ///< The bias grows so much from the scenario's start [rad/s].

  /// Measured less true, `elapsed` [s] after the scenario's start, for a true azimuth in the antenna's plane [rad].
  double at(double azimuth, double elapsed) const;
};

/// By how much a radar's clock is fast.
struct ClockErrors {
  double offset = 0.0;  ///< Told less true, at the scenario's start [s].
  double drift = 0.0;   ///< The offset grows so much a second [s/s].

  double at(double elapsed) const { return offset + drift * elapsed; }
};

/// What a rotating radar has wrong about its place among the others. Of itself it knows nothing of it.
struct RegistrationErrors {
  double range_bias = 0.0;    ///< Measured less true [m].
  double range_gain = 0.0;    ///< Measured over true range, less 1.
  bool air_delays = false;    ///< Ranges of targets are too long by what the air delays (tws::airDelay).
  AzimuthErrors azimuth;      ///< Of plots and sector marks.
  double tilt = 0.0;          ///< The axis of rotation leans by so much from the vertical [rad], >= 0 ...
  double tilt_azimuth = 0.0;  ///< ... towards here [rad].
  ClockErrors clock;          ///< Of all stamps.

  /// As measured [m]; of a range through the air.
  double rangeMeasured(double range) const { return range * (1.0 + range_gain) + range_bias; }
  /// What the air adds to the range of a target [m]: heights above the sea [m], slant range > 0 [m].
  double delayOf(double antenna_height, double target_height, double slant_range) const;
  /// Takes map coordinates to the antenna's own axes, given those to the site's east, north, up. They lean with the
  /// axis of rotation, without a turn about the vertical.
  Eigen::Isometry3d toAntenna(const Eigen::Isometry3d& map_to_site) const;
};

}  // namespace radar_sim
