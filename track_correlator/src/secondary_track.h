#pragma once

#include <cstdint>
#include <string>

#include <tws_core/kalman.h>

#include "code_history.h"
#include "secondary_plot.h"

namespace track_correlator {

/// One aircraft as the secondary tracker knows it. The plane of motion is that of slant range and azimuth.
struct SecondaryTrack {
  std::uint32_t uid = 0;     ///< From 1; never used twice in one run.
  tws::PlanarState state;    ///< At `time`, x east and y north of the radar.
  double time = 0.0;         ///< Of the state [s].
  double last_update = 0.0;  ///< Of the last plot [s].
  double first_time = 0.0;   ///< Of the first plot [s].
  int plots = 0;             ///< Plots so far.
  int misses = 0;            ///< Scans in a row without one.
  bool firm = false;
  CodeHistory mode_1, mode_2, mode_3a;
  HeightHistory height;
  std::uint32_t aircraft_address = 0;
  std::string callsign;
  std::int64_t done = 0;  ///< Running sector in which it was processed last.
};

/// What a plot's identity says of a track's.
enum class Agreement { kSame, kUnknown, kOtherCode, kOtherAircraft };

/// By the aircraft address where both are known, else by mode 3/A. A garbled code says nothing.
Agreement agreementOf(const SecondaryTrack& track, const SecondaryPlot& plot);

/// Whether the plot's mode 3/A may be the track's under another reply: overlapping pulses only add bits.
bool mayHideCodeOf(const SecondaryTrack& track, const SecondaryPlot& plot);

}  // namespace track_correlator
