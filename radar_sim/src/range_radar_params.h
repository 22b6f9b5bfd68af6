#pragma once

#include <limits>
#include <string>

#include <tws_core/units.h>

namespace radar_sim {

/// Sea clutter: speckle on patches of slowly changing reflectivity (compound Gaussian, K-distributed amplitude).
struct GateSeaClutter {
  double sigma0 = 0.0;  ///< Mean radar cross-section of a square metre of sea, linear; 0: none.
  double shape =
      std::numeric_limits<double>::infinity();  ///< ν of the gamma distribution of patches; infinite: all alike.
  double patch_length = 50.0;                   ///< [m]
  double patch_time = 1.0;                      ///< A patch lives so long [s].
};

/// A radar that stares at one target and reports amplitude range profiles of an open range gate (MRS).
struct RangeRadarParams {
  std::string name;  ///< Also the topic's first part and the tf frame.
  std::string site;
  std::string target;  ///< The beam follows it; how, is not modelled.

  double antenna_height = 25.0;        ///< Above the sea [m].
  double beamwidth = tws::radians(2);  ///< Half power, one way, of a round beam [rad].
  double wavelength = 0.03;            ///< [m]

  // The gate.
  double profile_rate = 50.0;                                     ///< [1/s]
  double bin_size = 1.0;                                          ///< [m]
  double resolution = 1.5;                                        ///< Half-power width of a point's echo [m].
  double start_range = std::numeric_limits<double>::quiet_NaN();  ///< Centre at the start [m]; NaN: on the target.
  double gate_length = 1200.0;                                    ///< At the start [m].
  double min_range = 500.0;                                       ///< Where the gate may lie [m].
  double max_range = 40e3;
  double latency = 0.1;  ///< From the stamp of a command to its effect [s of data time], > 0.

  // What is there besides targets.
  double noise_rcs = 1e-4;    ///< Mean receiver noise in a bin as a cross-section at noise_range [m²].
  double noise_range = 10e3;  ///< [m]; elsewhere noise grows with the fourth power of range.
  GateSeaClutter sea_clutter;
};

}  // namespace radar_sim
