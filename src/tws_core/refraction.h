#pragma once

#include <tws_core/geodesy.h>

namespace tws {

/// Elevation and height over a round earth without terrain. Rays bend with the atmosphere; over an earth of 4/3 of the
/// true radius they are straight (Skolnik, Introduction to Radar Systems, 2nd ed., section 12.4). A radar measures over
/// that one; where a target is in space follows over the true one, kMeanEarthRadius.
constexpr double kEffectiveEarthRadius = 4.0 / 3.0 * kMeanEarthRadius;  // [m]

/// Sine of the elevation at which a target appears, -1 .. 1. Heights above the sea [m], slant range > 0 [m].
double sineOfElevation(double antenna_height, double target_height, double slant_range,
                       double earth_radius = kEffectiveEarthRadius);

/// The inverse: height above the sea [m] of what appears there.
double heightOf(double antenna_height, double sine_of_elevation, double slant_range,
                double earth_radius = kEffectiveEarthRadius);

/// By how much a radar overstates the range of a target because air slows its waves [m]: the integral of the
/// refractivity along the ray, which is straight over the effective earth. Refractivity as in ITU-R P.453-14: 315e-6
/// exp(-h / 7.35 km). Heights above the sea [m], slant range > 0 [m]. About 2.3 m through the zenith, 85 m for an
/// aircraft at 10 km, 400 km away.
double airDelay(double antenna_height, double target_height, double slant_range);

}  // namespace tws
