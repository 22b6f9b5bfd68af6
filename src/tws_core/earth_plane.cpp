#include <tws_core/earth_plane.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace tws {
namespace {

/// The ellipsoid at a height: |q|² + flatness·(pole·q)² = radius² for a point q from the earth's centre.
struct Surface {
  explicit Surface(double height) {
    const double a = kSemiMajorAxis + height, b = kSemiMinorAxis + height;
    squared_radius = a * a;
    flatness = squared_radius / (b * b) - 1.0;
  }
  double squared_radius, flatness;
};

constexpr double kSteepest = 0.94868329805;  // sine of the elevation: a tenth of r² is left to the ground range

}  // namespace

EarthPlane::EarthPlane(const Geodetic& origin, const Eigen::Vector3d& at, double turn) {
  const LocalFrame frame(origin);
  const Eigen::Matrix3d& ecef_from_enu = frame.ecefFromEnuRotation();
  const Eigen::Vector3d from_centre = ecef_from_enu.transpose() * ecefFromGeodetic(origin) + at;
  const double c = std::cos(turn), s = std::sin(turn);
  const auto turned = [&](const Eigen::Vector3d& v) {
    return Eigen::Vector3d(c * v.x() + s * v.y(), c * v.y() - s * v.x(), v.z());
  };
  centre_to_origin_ = turned(from_centre);
  pole_ = turned(ecef_from_enu.row(2).transpose());
}

double EarthPlane::zAt(double x, double y, double height) const {
  const Surface surface(height);
  const Eigen::Vector3d q = centre_to_origin_ + Eigen::Vector3d(x, y, 0.0);
  const double along = pole_.dot(q);
  const double a = 1.0 + surface.flatness * pole_.z() * pole_.z();
  const double half_b = q.z() + surface.flatness * along * pole_.z();
  const double c = q.squaredNorm() + surface.flatness * along * along - surface.squared_radius;
  return -c / (half_b + std::sqrt(half_b * half_b - a * c));
}

double EarthPlane::heightOf(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d q = centre_to_origin_ + point;
  const double z = pole_.dot(q);
  return geodeticFromEcef({(q - z * pole_).norm(), 0.0, z}).altitude;
}

Eigen::Vector3d EarthPlane::upAt(const Eigen::Vector3d& point) const {
  const Eigen::Vector3d q = centre_to_origin_ + point;
  const double z = pole_.dot(q);
  const Eigen::Vector3d outwards = q - z * pole_;  // from the earth's axis
  const double distance = outwards.norm();
  if (distance == 0.0) return z < 0.0 ? Eigen::Vector3d(-pole_) : pole_;
  const double latitude = geodeticFromEcef({distance, 0.0, z}).latitude;
  return std::cos(latitude) / distance * outwards + std::sin(latitude) * pole_;
}

// A site's east axis lies on the plane in the direction of its frame, and is at right angles to its vertical.
EarthSite::EarthSite(const EarthPlane& plane, const SiteFrame& frame)
    : plane_(plane), at_(frame.x, frame.y, frame.z), up_(plane.upAt(at_)) {
  const double c = std::cos(frame.turn), s = std::sin(frame.turn);
  east_ = Eigen::Vector3d(c, s, -(up_.x() * c + up_.y() * s) / up_.z()).normalized();
  north_ = up_.cross(east_);
  centre_ = plane.centre_to_origin_ + at_;
  height_ = plane.heightOf(at_);
}

/// From the surface |q|² + f·(pole·q)² = A² with q = site + r·(cos·outwards + sin·up), whose left side hardly bends
/// with the sine: two steps of Newton's method from the horizontal are good to a millimetre at any range.
PlaceAtHeight EarthSite::placeOf(double range, double azimuth, double range_sigma, double azimuth_sigma,
                                 double height) const {
  const Surface surface(height);
  const double sa = std::sin(azimuth), ca = std::cos(azimuth);
  const Eigen::Vector3d outwards = sa * east_ + ca * north_;
  const Eigen::Vector3d& pole = plane_.pole_;
  const double eq = outwards.dot(centre_), uq = up_.dot(centre_);
  const double ep = outwards.dot(pole), up = up_.dot(pole), qp = centre_.dot(pole);
  const double constant = centre_.squaredNorm() + range * range - surface.squared_radius;
  double sine = 0.0, cosine = 1.0, slope = 1.0;
  for (int step = 0; step < 3; ++step) {
    const double along = qp + range * (cosine * ep + sine * up);
    const double value = constant + 2.0 * range * (cosine * eq + sine * uq) + surface.flatness * along * along;
    const double bend = sine / cosine;
    slope = 2.0 * range * (uq - bend * eq + surface.flatness * along * (up - bend * ep));
    sine = std::clamp(sine - value / slope, -kSteepest, kSteepest);
    cosine = std::sqrt(1.0 - sine * sine);
  }
  const Eigen::Vector3d line = cosine * outwards + sine * up_;
  PlaceAtHeight result{};
  result.place.x = at_.x() + range * line.x();
  result.place.y = at_.y() + range * line.y();
  const Eigen::Vector2d per_height = perHeight(outwards, sine, range);
  result.x_per_height = per_height.x();
  result.y_per_height = per_height.y();
  result.up = range * sine;
  // At the same height, a longer range is a lower elevation.
  const double along = qp + range * line.dot(pole);
  const double by_range = 2.0 * (range + line.dot(centre_) + surface.flatness * along * line.dot(pole));
  const Eigen::Vector2d dr =
      range_sigma * (line - range * by_range / slope * (up_ - sine / cosine * outwards)).head<2>();
  const Eigen::Vector2d da = azimuth_sigma * range * cosine * (ca * east_ - sa * north_).head<2>();
  result.place.covariance = {dr.x() * dr.x() + da.x() * da.x(), dr.x() * dr.y() + da.x() * da.y(),
                             dr.y() * dr.y() + da.y() * da.y()};
  return result;
}

/// The elevation's sine grows by 1/range a metre of height, but for the angle between the verticals of site and target.
Eigen::Vector2d EarthSite::perHeight(const Eigen::Vector3d& outwards, double sine, double range) const {
  const double cosine = std::sqrt(std::max(1.0 - sine * sine, 1.0 - kSteepest * kSteepest));
  const Eigen::Vector3d target = centre_ + range * (cosine * outwards + sine * up_);
  const double per_sine = up_.dot(target) - sine / cosine * outwards.dot(target);
  return target.norm() / per_sine * (up_ - sine / cosine * outwards).head<2>();
}

SiteView EarthSite::view(double x, double y, double height) const {
  const Eigen::Vector3d line = Eigen::Vector3d(x, y, plane_.zAt(x, y, height)) - at_;
  SiteView view{};
  view.east = east_.dot(line);
  view.north = north_.dot(line);
  view.up = up_.dot(line);
  const double ground2 = view.east * view.east + view.north * view.north;
  view.ground = std::max(std::sqrt(ground2), 1.0);
  view.range = std::max(std::sqrt(ground2 + view.up * view.up), 1.0);
  view.azimuth = wrapTwoPi(std::atan2(view.east, view.north));
  return view;
}

Eigen::Matrix2d EarthSite::onGround(double x, double y, double height) const {
  const Surface surface(height);
  const Eigen::Vector3d q = plane_.centre_to_origin_ + Eigen::Vector3d(x, y, plane_.zAt(x, y, height));
  const Eigen::Vector3d normal = q + surface.flatness * plane_.pole_.dot(q) * plane_.pole_;
  const Eigen::Vector2d slope = -normal.head<2>() / normal.z();
  Eigen::Matrix2d jacobian;
  jacobian << east_.x() + east_.z() * slope.x(), east_.y() + east_.z() * slope.y(), north_.x() + north_.z() * slope.x(),
      north_.y() + north_.z() * slope.y();
  return jacobian;
}

Eigen::Vector2d EarthSite::perHeight(const SiteView& view) const {
  const Eigen::Vector3d outwards = (view.east * east_ + view.north * north_) / view.ground;
  return perHeight(outwards, view.up / view.range, view.range);
}

}  // namespace tws
