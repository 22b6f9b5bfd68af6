#pragma once

#include "array_params.h"

namespace radar_sim {

/// Where a beam of an array points, or a target is seen, in sine space.
struct BeamPoint {
  double u = 0.0;
  double v = 0.0;
};

/// Distance of two directions in beamwidths: 0.5 is the half-power contour round the centre of a beam.
double beamwidthsApart(const ArrayParams& array, const BeamPoint& a, const BeamPoint& b);

/// One-way power gain of a beam relative to its peak: Gaussian in sine space, 1/2 at half a beamwidth (Barton, Modern
/// Radar System Analysis, section 3.2; in angle the beam so broadens as 1/cos of the scan angle).
double beamGain(const ArrayParams& array, const BeamPoint& beam, const BeamPoint& target);

/// Whether the beam can be steered there: in front of the array, no further off boresight than it scans.
bool canSteer(const ArrayParams& array, const BeamPoint& beam);

/// Mean SNR (linear) of an echo in the beam: reference SNR · σ · (R0/R)⁴ · cos(scan angle)^n · gain². 0 further than
/// one beamwidth from the beam's centre: what comes through side lobes is blanked. `rcs` [m²]; `range` > 0 [m].
double arraySnr(const ArrayParams& array, const BeamPoint& beam, const BeamPoint& target, double range, double rcs);

/// Standard deviation of a measurement: root of floor² + (cell / (1.6 sqrt(2 S)))² (Barton, section 8.2). `cell`: the
/// range cell, or the beamwidth for a monopulse angle.
double arraySigma(double floor, double cell, double snr);

}  // namespace radar_sim
