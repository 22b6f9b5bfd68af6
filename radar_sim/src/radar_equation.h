#pragma once

#include "radar_params.h"

namespace radar_sim {

/// Range cell, c·τ/2 [m].
double rangeCell(const RadarParams& radar);

/// One-way power gain of a beam relative to its peak, for an elevation [rad].
double elevationGain(const ElevationBeam& beam, double elevation);

/// Signal-to-noise ratio (linear) after integration of a target of radar cross-section `rcs` [m²], in the beam with the
/// most signal:
///   S = Pt G² λ² σ F⁴ n η / ((4π)³ R⁴ k T0 B Fn L),  B = 1/τ          (Skolnik, 2nd ed., eq. 2.34 with the factor
///   of 12.2)
/// 0 beyond the radar horizon. `target_height` above the sea [m]; `slant_range` > 0 [m].
double meanSnr(const RadarParams& radar, double rcs, double slant_range, double target_height);

/// Standard deviation of a measurement [unit of `cell`]: `floor`, or with snr_dependent_noise the root of
/// floor² + (cell / (1.6 sqrt(2 S)))² (Barton, Modern Radar System Analysis, section 8.2).
double noiseSigma(const RadarParams& radar, double floor, double cell, double snr);

}  // namespace radar_sim
