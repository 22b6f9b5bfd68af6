#pragma once

#include <string>
#include <vector>

#include <tws_core/quantisation.h>
#include <tws_core/units.h>

namespace radar_sim {

/// One elevation beam of a rotating antenna.
struct ElevationBeam {
  double elevation = 0.0;  ///< Of the peak [rad].
  double beamwidth = 0.1;  ///< Full width at half power [rad].
  /// Above its upper half-power point the gain falls as cosec² up to here [rad], so that an aircraft at constant height
  /// keeps its signal; 0: no such shaping.
  double cosecant_to = 0.0;
};

/// One rotating search radar. Defaults are those of no particular set.
struct RadarParams {
  std::string name;  ///< Also the topic's first part and the tf frame.
  std::string site;

  // Antenna and rotation.
  double rotation_period = 6.0;                       ///< [s]
  double start_azimuth = 0.0;                         ///< Where the beam points at the scenario's start [rad].
  double antenna_height = 25.0;                       ///< Above the sea [m].
  double azimuth_beamwidth = tws::radians(2.0);       ///< Full width at half power [rad]; also the resolution.
  std::vector<ElevationBeam> beams{ElevationBeam{}};  ///< Each target is seen by the one with the most signal.

  // Radar equation (single pulse), then integration.
  double peak_power = 500e3;              ///< [W]
  double antenna_gain = 1000.0;           ///< Power ratio at the beam's peak.
  double wavelength = 0.23;               ///< [m]
  double pulse_width = 1e-6;              ///< [s]; also the range cell, c·pulse_width/2.
  double noise_figure = 4.0;              ///< Power ratio.
  double losses = 4.0;                    ///< Power ratio, everything two-way.
  double pulses = 16.0;                   ///< Integrated while the beam is on a target.
  double integration_efficiency = 0.5;    ///< Of the ideal gain, which is `pulses`.
  double false_alarm_probability = 1e-6;  ///< Of one test; sets the threshold.
  double sea_reflection = 0.9;            ///< Magnitude of the reflection coefficient, 0 .. 1.

  // Coverage.
  double min_range = 1000.0;  ///< [m]
  double max_range = 185e3;   ///< Instrumented range [m].

  // Measurement.
  double range_sigma = 100.0;                ///< [m]
  double azimuth_sigma = tws::radians(0.3);  ///< [rad]
  bool snr_dependent_noise = false;          ///< The sigmas are then the floor, see noiseSigma().
  double range_lsb = tws::kRangeLsb;         ///< [m]; 0: not quantised.
  double azimuth_lsb = tws::kAzimuthLsb;     ///< [rad]; 0: not quantised.
  double time_lsb = tws::kTimeLsb;           ///< Clock tick for plots and marks [s]; 0: not quantised.

  // False alarms.
  double false_alarms_per_scan = 20.0;  ///< Poisson mean.
  bool false_alarms_by_area = true;     ///< Uniform over area; false: uniform over range cells.
};

}  // namespace radar_sim
