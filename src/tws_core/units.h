#pragma once

namespace tws {

/// Conversions at the edges; inside, everything is in SI and radians. All are exact by definition of the unit.
constexpr double kMetresPerFoot = 0.3048;
constexpr double kMetresPerNauticalMile = 1852.0;
/// [m/s per kn]
constexpr double kMetresPerSecondPerKnot = kMetresPerNauticalMile / 3600.0;
constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180.0;

constexpr double radians(double degrees) { return degrees * kRadiansPerDegree; }
constexpr double degrees(double radians) { return radians / kRadiansPerDegree; }
constexpr double metresFromFeet(double feet) { return feet * kMetresPerFoot; }
constexpr double feetFromMetres(double metres) { return metres / kMetresPerFoot; }
constexpr double metresFromNauticalMiles(double nautical_miles) { return nautical_miles * kMetresPerNauticalMile; }
constexpr double nauticalMilesFromMetres(double metres) { return metres / kMetresPerNauticalMile; }
/// [m/s] from [kn]
constexpr double speedFromKnots(double knots) { return knots * kMetresPerSecondPerKnot; }
/// [kn] from [m/s]
constexpr double knotsFromSpeed(double speed) { return speed / kMetresPerSecondPerKnot; }

}  // namespace tws
