#pragma once

#include "frame.h"

namespace esa_frame_builder {

/// A measurement with errors of 10 m in range and 0.0005 in u and v.
inline Measurement measurementAt(double range, double u, double v, double snr = 100.0) {
  Measurement measurement;
  measurement.range = range;
  measurement.u = u;
  measurement.v = v;
  measurement.covariance.diagonal() << 100.0, 0.25e-6, 0.25e-6;
  measurement.snr = snr;
  measurement.rcs = 1.0;
  return measurement;
}

/// A beam 0.02 wide in u and in v.
inline Dwell dwellAt(double time, double u, double v, std::vector<Measurement> measurements = {}) {
  Dwell dwell;
  dwell.time = time;
  dwell.u = u;
  dwell.v = v;
  dwell.beamwidth_u = dwell.beamwidth_v = 0.02;
  dwell.range_max = 200e3;
  dwell.measurements = std::move(measurements);
  return dwell;
}

}  // namespace esa_frame_builder
