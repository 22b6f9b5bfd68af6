#pragma once

#include <Eigen/Core>

namespace tws {

/// A place as a radar sees it.
struct Polar {
  double range = 0.0;      // slant range [m], not negative
  double azimuth = 0.0;    // clockwise from true north [rad]
  double elevation = 0.0;  // up from the horizontal [rad], in [-π/2, π/2]
};

/// Time derivatives of a Polar.
struct PolarRates {
  double range = 0.0;      // [m/s]
  double azimuth = 0.0;    // [rad/s]
  double elevation = 0.0;  // [rad/s]
};

/// East, north, up [m] from the radar. No check: a NaN in gives NaN out.
Eigen::Vector3d enuFromPolar(const Polar& polar);
/// Azimuth in [0, 2π). Straight up or down the azimuth is 0; at the radar itself all three are 0.
Polar polarFromEnu(const Eigen::Vector3d& enu);

/// Velocity in ENU [m/s] of a target at `polar` with these rates.
Eigen::Vector3d enuVelocity(const Polar& polar, const PolarRates& rates);
/// Rates of a target at `enu` [m] moving at `velocity` [m/s]. Angle rates that do not exist (straight up, at the radar)
/// are 0; at the radar the range rate is the speed.
PolarRates polarRates(const Eigen::Vector3d& enu, const Eigen::Vector3d& velocity);

/// Over a flat earth, height above the radar [m]; a slant range below the height gives 0, never NaN.
double groundRange(double slant_range, double height);
double slantRange(double ground_range, double height);

/// The plane of 2-D trackers: x = r·sin(azimuth) east, y = r·cos(azimuth) north [m].
Eigen::Vector2d planarFromPolar(double range, double azimuth);
/// [m/s] from range rate [m/s] and azimuth rate [rad/s].
Eigen::Vector2d planarVelocity(double range, double azimuth, double range_rate, double azimuth_rate);
/// Azimuth of a planar position, or course of a planar velocity, in [0, 2π); 0 for the zero vector.
double azimuthOf(const Eigen::Vector2d& planar);

}  // namespace tws
