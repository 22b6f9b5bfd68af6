#pragma once

#include <tws_core/geodesy.h>

namespace radar_sim {

/// Propagation over a smooth sea on a round earth. Refraction is taken in by an effective earth radius of 4/3 of the
/// true one (Skolnik, Introduction to Radar Systems, 2nd ed., section 12.4).
constexpr double kEffectiveEarthRadius = 4.0 / 3.0 * tws::kMeanEarthRadius;  // [m]

/// Distance to the horizon of an antenna, sqrt(2 a h) [m]; height above the sea >= 0 [m].
double horizonDistance(double height);

/// Sine of the elevation at which a target appears, over the 4/3 earth. Heights above the sea [m], slant range > 0 [m].
double sineOfElevation(double antenna_height, double target_height, double slant_range);

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
