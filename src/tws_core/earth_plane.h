#pragma once

#include <Eigen/Core>

#include <tws_core/angles.h>
#include <tws_core/geodesy.h>
#include <tws_core/planar_gaussian.h>
#include <tws_core/site_frame.h>

namespace tws {

/// Where a map lies of which nobody says it. Joining sites then is good to 12 m over 1000 km: the ellipsoid's curvature
/// differs by 1 % at most from place to place.
constexpr Geodetic kSomewhere{kPi / 4.0, 0.0, 0.0};

/// The plane on which a tracker of several sites works, and the WGS-84 ellipsoid under it. A point is x, y [m] on the
/// plane and a height above the ellipsoid [m]; z above the plane follows from both. No projection: x, y, z are right
/// angled coordinates in space.
///
/// The surface at height h is taken for the ellipsoid with half axes longer by h: 0.1 m off at 20 km of height.
class EarthPlane {
 public:
  EarthPlane() : EarthPlane(kSomewhere) {}
  /// The plane's origin is at `at` [m] in the east, north, up of `origin`, its axes are those turned anticlockwise by
  /// `turn` [rad] about up. Throws std::invalid_argument as LocalFrame.
  explicit EarthPlane(const Geodetic& origin, const Eigen::Vector3d& at = Eigen::Vector3d::Zero(), double turn = 0.0);

  /// z [m] of what is at x, y [m] at a height [m] above the ellipsoid. NaN beyond the horizon of the other side.
  double zAt(double x, double y, double height) const;
  /// Height above the ellipsoid [m].
  double heightOf(const Eigen::Vector3d& point) const;
  /// The ellipsoid's normal below a point; of length 1.
  Eigen::Vector3d upAt(const Eigen::Vector3d& point) const;

 private:
  friend class EarthSite;
  Eigen::Vector3d centre_to_origin_;  // [m]
  Eigen::Vector3d pole_;              // direction of the earth's axis; of length 1
};

/// A plot, or a place where a plot may come from, on the plane, under a guess of the target's height.
struct PlaceAtHeight {
  PlanarPosition place;               // covariance: of the radar's own errors alone
  double x_per_height, y_per_height;  // how it changes with the height [m/m]
  double up;                          // of the target above the site's horizontal plane [m]
};

/// A point as a radar sees it.
struct SiteView {
  double east, north, up;  // in the radar's own axes [m]
  double ground;   // distance along its horizontal plane [m], at least 1: at the site itself rates have no meaning
  double range;    // slant range [m], at least 1
  double azimuth;  // from its own north [rad], [0, 2π)
};

/// A radar on the earth: its plots on the plane and back, exactly. Its vertical is the ellipsoid's normal where it
/// stands, whatever its transform says of tilt; its north is that of its transform.
class EarthSite {
 public:
  EarthSite(const EarthPlane& plane, const SiteFrame& frame);

  /// Antenna above the ellipsoid [m].
  double height() const { return height_; }
  /// Where a plot is, under that height [m]; what would be steeper than 71° is seen at 71°.
  PlaceAtHeight placeOf(double range, double azimuth, double range_sigma, double azimuth_sigma, double height) const;
  /// The inverse.
  SiteView view(double x, double y, double height) const;
  /// How the point's place in the radar's east and north changes with x and y of the plane, at the same height.
  Eigen::Matrix2d onGround(double x, double y, double height) const;
  /// How the place of what is seen so changes with its height, on the plane, at the same slant range and azimuth.
  Eigen::Vector2d perHeight(const SiteView& view) const;

 private:
  Eigen::Vector2d perHeight(const Eigen::Vector3d& outwards, double sine, double range) const;

  EarthPlane plane_;
  Eigen::Vector3d at_;  // on the plane [m]
  Eigen::Vector3d east_, north_, up_;
  Eigen::Vector3d centre_;  // from the earth's centre [m]
  double height_;
};

}  // namespace tws
