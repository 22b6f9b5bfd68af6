#pragma once

#include <string>
#include <vector>

#include <tws_core/quantisation.h>
#include <tws_core/units.h>

#include "registration_errors.h"
#include "transponder.h"

namespace radar_sim {

/// One rotating secondary radar (SSR, IFF) with a plot extractor.
struct SecondaryParams {
  std::string name;  ///< Also the topic's first part and the tf frame.
  std::string site;
  std::string mast;  ///< The primary radar on whose mast it turns; empty: one of its own.

  // Antenna and rotation; those of the mast's radar are copied here.
  double rotation_period = 6.0;                  ///< [s]
  double start_azimuth = 0.0;                    ///< Where the beam points at the scenario's start [rad].
  double antenna_height = 25.0;                  ///< Above the sea [m].
  double time_lsb = tws::kTimeLsb;               ///< Clock tick for plots and marks [s]; 0: not quantised.
  double azimuth_beamwidth = tws::radians(2.4);  ///< Aircraft reply within it; also the azimuth resolution [rad].

  // Interrogation and extraction.
  double interrogation_rate = 360.0;  ///< [1/s]; with a beam of 2.4° and 6 s a revolution, 14.4 interrogations a target
  std::vector<Mode> interlace{Mode::k3A, Mode::kC, Mode::k1, Mode::k3A, Mode::kC, Mode::k2};  ///< Over and over.
  double missed_reply_probability = 0.05;                                                     ///< Of each reply.
  long needed_replies = 4;            ///< In all modes together, for a plot.
  long needed_code_replies = 2;       ///< In one mode, for its code.
  double fruit_plots_per_scan = 1.0;  ///< Poisson mean of plots made of replies to other interrogators.

  // Coverage.
  double min_range = 1000.0;  ///< [m]
  double max_range = 370e3;   ///< [m]

  // Measurement.
  double range_sigma = 60.0;                  ///< [m]
  double azimuth_sigma = tws::radians(0.15);  ///< [rad]
  double range_lsb = tws::kRangeLsb;          ///< [m]; 0: not quantised.
  double azimuth_lsb = tws::kAzimuthLsb;      ///< [rad]; 0: not quantised.
  RegistrationErrors errors;                  ///< Those of the mast's turning gear and clock are copied here.
  double beam_offset = 0.0;  ///< Of its own plots against the mast's azimuth: measured less true [rad].
};

}  // namespace radar_sim
