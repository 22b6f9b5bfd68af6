#include "array_beam.h"

#include <cmath>

#include <tws_core/sine_space.h>

namespace radar_sim {

double beamwidthsApart(const ArrayParams& array, const BeamPoint& a, const BeamPoint& b) {
  return std::hypot((a.u - b.u) / array.beamwidth_u, (a.v - b.v) / array.beamwidth_v);
}

double beamGain(const ArrayParams& array, const BeamPoint& beam, const BeamPoint& target) {
  const double apart = beamwidthsApart(array, beam, target);
  return std::exp(-4.0 * std::log(2.0) * apart * apart);
}

bool canSteer(const ArrayParams& array, const BeamPoint& beam) {
  return std::hypot(beam.u, beam.v) <= std::sin(array.greatest_scan);
}

double arraySnr(const ArrayParams& array, const BeamPoint& beam, const BeamPoint& target, double range, double rcs) {
  if (!tws::isVisible(target.u, target.v) || beamwidthsApart(array, beam, target) > 1.0) return 0.0;
  const double cosine = std::sqrt(1.0 - target.u * target.u - target.v * target.v);
  const double shape = beamGain(array, beam, target);
  return array.reference_snr * rcs * std::pow(array.reference_range / range, 4) *
         std::pow(cosine, array.scan_loss_exponent) * shape * shape;
}

double arraySigma(double floor, double cell, double snr) {
  return std::hypot(floor, cell / (1.6 * std::sqrt(2.0 * snr)));
}

}  // namespace radar_sim
