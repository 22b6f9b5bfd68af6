#pragma once

#include <tws_core/refraction.h>

namespace radar_sim {

// Propagation over a smooth sea on a round earth, refraction included.
using tws::kEffectiveEarthRadius;
using tws::sineOfElevation;

/// Distance to the horizon of an antenna, sqrt(2 a h) [m]; height above the sea >= 0 [m].
double horizonDistance(double height);

/// The target lies beyond the radar horizon, so that only diffraction would reach it.
bool isBeyondHorizon(double antenna_height, double target_height, double slant_range);

/// Pattern propagation factor F² (one way, power; 0 .. 4) of the direct ray and the one reflected by the sea, for one
/// elevation. F² = |f_d - rho f_r exp(j 2π δ/λ)|², with the path difference δ = 2 h sin(elevation): maxima where h
/// sin(elevation) is an odd multiple of λ/4, nulls at even ones (Skolnik, eqs. 12.1 to 12.4). The two-way power factor
/// is F⁴.
///   direct_gain, reflected_gain: voltage pattern towards the target and towards the sea below it, 1 at the beam's
///   peak. reflection: magnitude of the sea's reflection coefficient, 0 .. 1 (1: a mirror).
double propagationFactor(double antenna_height, double wavelength, double sine_of_elevation, double direct_gain,
                         double reflected_gain, double reflection);

}  // namespace radar_sim
