#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

namespace track_correlator {

/// A mode 1, 2 or 3/A code that is not known. Known ones are 0 .. 4095.
constexpr std::uint16_t kNoCode = 65535;

/// One code as a secondary radar received it.
struct CodeReply {
  std::uint16_t code = kNoCode;
  bool garbled = false;  ///< Another reply overlapped it, as far as the radar could tell.
};

/// One target report of a secondary radar. What is unknown is NaN, kNoCode, 0 or empty.
struct SecondaryPlot {
  double time = 0.0;                                         ///< The beam was on the target [s of data time].
  double range = 0.0;                                        ///< Slant range [m], > 0.
  double azimuth = 0.0;                                      ///< Clockwise from true north [rad], [0, 2 pi).
  double height = std::numeric_limits<double>::quiet_NaN();  ///< Pressure altitude [m].
  bool height_garbled = false;
  CodeReply mode_1, mode_2, mode_3a;
  std::uint32_t aircraft_address = 0;  ///< 24 bits; 0: unknown.
  std::string callsign;
};

/// A fixed order of the plots of one sector, so that the order in which they were sent does not matter.
inline bool comesBefore(const SecondaryPlot& a, const SecondaryPlot& b) {
  return std::tie(a.time, a.range, a.azimuth, a.mode_3a.code, a.mode_1.code, a.mode_2.code, a.aircraft_address) <
         std::tie(b.time, b.range, b.azimuth, b.mode_3a.code, b.mode_1.code, b.mode_2.code, b.aircraft_address);
}

/// What a secondary radar received while its beam crossed one of 64 azimuth sectors.
struct SecondarySector {
  std::int64_t running = 0;  ///< Sectors since the radar's start; modulo 64 it is the sector's number.
  double leave_time = 0.0;   ///< The beam left it [s of data time].
  std::vector<SecondaryPlot> plots;
};

}  // namespace track_correlator
