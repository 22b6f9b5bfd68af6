#pragma once

#include <tws_core/angles.h>
#include <tws_core/plot.h>

namespace adit_tracker {

inline tws::Plot plotAt(double time, double range, double azimuth = 0.0) {
  tws::Plot plot;
  plot.time = time;
  plot.range = range;
  plot.azimuth = tws::wrapTwoPi(azimuth);
  return plot;
}

}  // namespace adit_tracker
