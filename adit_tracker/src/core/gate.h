#pragma once

#include <cmath>

#include <tws_core/quantisation.h>

namespace adit_tracker {

/// A correlation region: a detection within both half-widths is inside.
struct Gate {
  double range = 0.0;           // CRC, CRT [m]
  double azimuth = 0.0;         // CAC, CAT [rad]
  double range_weight = 4.0;    // K1, KCRT: of the range difference, in its LSB
  double azimuth_weight = 1.0;  // K2, KCAT: of the azimuth difference, in its LSB
};

/// The report's effective distance DI = K1·DELR + K2·DELA, the differences counted in their LSBs.
inline double effectiveDistance(const Gate& gate, double range_difference, double azimuth_difference) {
  return gate.range_weight * std::abs(range_difference) / tws::kRangeLsb +
         gate.azimuth_weight * std::abs(azimuth_difference) / tws::kAzimuthLsb;
}

}  // namespace adit_tracker
