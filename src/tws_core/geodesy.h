#pragma once

#include <Eigen/Core>

namespace tws {

// World Geodetic System 1984 (NGA.STND.0036, table 3.1).
constexpr double kSemiMajorAxis = 6378137.0;  // [m]
constexpr double kFlattening = 1.0 / 298.257223563;
constexpr double kSemiMinorAxis = kSemiMajorAxis * (1.0 - kFlattening);  // [m]

/// A place on or above the WGS-84 ellipsoid.
struct Geodetic {
  double latitude = 0.0;   // [rad], north positive, in [-π/2, π/2]
  double longitude = 0.0;  // [rad], east positive
  double altitude = 0.0;   // above the ellipsoid [m]
};

/// Earth-centred, earth-fixed coordinates [m].
Eigen::Vector3d ecefFromGeodetic(const Geodetic& geodetic);
/// Longitude in (-π, π]. Good to better than a micrometre from 100 km below the ellipsoid to 1000 km above it.
Geodetic geodeticFromEcef(const Eigen::Vector3d& ecef);

constexpr double kMeanEarthRadius = 6371e3;  // [m]

/// Altitude [m] of a point given as east, north, up [m] about an origin at altitude 0 whose place is not known: over a
/// sphere, right to 0.6 % of what the plane sinks away (20 m at 200 km). With the place known, LocalFrame is exact.
double altitudeOverSphere(const Eigen::Vector3d& enu);

/// East, north, up [m] about an origin: the plane touches the ellipsoid there, so a distant point at constant altitude
/// sinks. No projection: distances are straight lines in space.
class LocalFrame {
 public:
  /// Throws std::invalid_argument when a coordinate is not finite or the latitude is outside [-π/2, π/2].
  explicit LocalFrame(const Geodetic& origin);

  const Geodetic& origin() const { return origin_; }
  /// Neither checks its input: a NaN in gives NaN out.
  Eigen::Vector3d toEnu(const Geodetic& geodetic) const;
  Geodetic toGeodetic(const Eigen::Vector3d& enu) const;
  /// The same rotation for velocities and axes: columns are this frame's east, north and up in ECEF.
  const Eigen::Matrix3d& ecefFromEnuRotation() const { return rotation_; }

 private:
  Geodetic origin_;
  Eigen::Vector3d origin_ecef_;
  Eigen::Matrix3d rotation_;
};

}  // namespace tws
