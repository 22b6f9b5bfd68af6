#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace tws {

/// One detection of a radar. What is unknown is NaN.
struct Plot {
  static constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

  double time = 0.0;                  ///< The beam was on the target [s of data time].
  double range = 0.0;                 ///< Slant range [m], > 0.
  double azimuth = 0.0;               ///< Clockwise from true north [rad], [0, 2 pi).
  double elevation = kUnknown;        ///< Up from the horizontal [rad], [-pi/2, pi/2].
  double range_rate = kUnknown;       ///< Measured Doppler range rate, positive outbound [m/s].
  double range_sigma = kUnknown;      ///< Standard deviation of the range [m], >= 0.
  double azimuth_sigma = kUnknown;    ///< Standard deviation of the azimuth [rad], >= 0.
  double elevation_sigma = kUnknown;  ///< Standard deviation of the elevation [rad], >= 0.
  double snr = kUnknown;              ///< Signal-to-noise ratio [dB].
};

/// What one rotating radar detected while its beam crossed one azimuth sector. The beam's time decides the sector of a
/// plot, not its measured azimuth.
struct RadarSector {
  int sector = 0;            ///< 0 .. 63; sector i covers azimuth [i, i + 1) * 2 pi / 64.
  std::int64_t running = 0;  ///< Sectors since the radar's start; modulo 64 it is `sector`. Never wraps.
  double enter_time = 0.0;   ///< The beam entered the sector [s of data time].
  double leave_time = 0.0;   ///< The beam left it, >= enter_time [s of data time].
  std::vector<Plot> plots;   ///< In order of time.
};

}  // namespace tws
