#pragma once

#include <optional>
#include <string>
#include <vector>

#include <tws_core/quantisation.h>
#include <tws_core/units.h>

#include "registration_errors.h"

namespace radar_sim {

/// One elevation beam of a rotating antenna.
struct ElevationBeam {
  double elevation = 0.0;  ///< Of the peak [rad].
  double beamwidth = 0.1;  ///< Full width at half power [rad].
  /// Above its upper half-power point the gain falls as cosec² up to here [rad], so that an aircraft at constant height
  /// keeps its signal; 0: no such shaping.
  double cosecant_to = 0.0;
};

/// How a radar searches in elevation where it is asked to: at a designated azimuth it begins several elevation scans,
/// which lie side by side in azimuth, and looks into a range interval. The search of the scan goes on beside them.
struct ElevationSearchParams {
  long per_turn = 8;                            ///< Searches that it takes for one revolution.
  long scans = 4;                               ///< Of one search.
  double width = tws::radians(7.0);             ///< Of azimuth, all scans of one search together [rad].
  double range_interval = 6000.0;               ///< Full length, centred on the designated range [m].
  double beamwidth = tws::radians(2.25);        ///< Of the scanned beam in elevation, full width at half power [rad].
  double max_elevation = tws::radians(45.0);    ///< Scans go from 0 up to here [rad].
  double pulses = 2.0;                          ///< Integrated while the scanned beam is on a target.
  double elevation_sigma = tws::radians(0.15);  ///< Of the elevation that one search measures [rad].
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
  double range_rate_sigma = 0.0;             ///< Of range rates (Doppler) [m/s]; 0: it measures none.
  double range_rate_span = 600.0;            ///< Full width over which those of false alarms are spread [m/s].
  double range_rate_ambiguity = 0.0;         ///< Range rates are told modulo this, and so span it [m/s]; 0: whole.
  double range_lsb = tws::kRangeLsb;         ///< [m]; 0: not quantised.
  double azimuth_lsb = tws::kAzimuthLsb;     ///< [rad]; 0: not quantised.
  double time_lsb = tws::kTimeLsb;           ///< Clock tick for plots and marks [s]; 0: not quantised.

  RegistrationErrors errors;

  // False alarms.
  double false_alarms_per_scan = 20.0;  ///< Poisson mean.
  bool false_alarms_by_area = true;     ///< Uniform over area; false: uniform over range cells.
  double clutter_suppression = 1.0;     ///< Power ratio beside what each kind of clutter says, see ClutterSpec.

  bool measuresRangeRates() const { return range_rate_sigma > 0.0; }

  std::optional<ElevationSearchParams> elevation_search;  ///< Nothing: it cannot.
};

}  // namespace radar_sim
