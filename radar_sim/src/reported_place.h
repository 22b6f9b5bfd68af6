#pragma once

#include <algorithm>

#include <tws_core/angles.h>
#include <tws_core/quantisation.h>

namespace radar_sim {

/// Range [m] and azimuth [rad] as a radar reports them: rounded to its least significant bits, the range never below
/// 1 m, to which noise may carry a very near plot, the azimuth in [0, 2 pi).
struct ReportedPlace {
  ReportedPlace(double measured_range, double measured_azimuth, double range_lsb, double azimuth_lsb)
      : range(std::max(tws::quantise(measured_range, range_lsb), 1.0)),
        azimuth(tws::wrapTwoPi(tws::quantise(measured_azimuth, azimuth_lsb))) {}

  double range, azimuth;
};

}  // namespace radar_sim
