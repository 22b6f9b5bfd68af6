#include "elevation/track_height.h"

#include <cmath>
#include <vector>

#include <tws_core/angles.h>
#include <tws_core/geometry.h>
#include <tws_core/refraction.h>
#include <Eigen/Core>

namespace adit_tracker {
namespace {

/// The covariance of (x, y, vx, vy) under the same linear map of positions and velocities, and what height and climb
/// rate add to each along the line of sight.
void mapCovariance(std::vector<double>& covariance, const Eigen::Matrix2d& map, const Eigen::Vector2d& by_height,
                   const Eigen::Vector2d& by_climb) {
  if (covariance.empty()) return;
  Eigen::Matrix4d whole = Eigen::Matrix4d::Zero();
  whole.topLeftCorner<2, 2>() = whole.bottomRightCorner<2, 2>() = map;
  using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
  Eigen::Map<RowMajor> p(covariance.data());
  p = (whole * p * whole.transpose()).eval();
  p.topLeftCorner<2, 2>() += by_height * by_height.transpose();
  p.bottomRightCorner<2, 2>() += by_climb * by_climb.transpose();
}

/// With slant range R, height h, place z above the radar's plane and ground range g, on an earth of radius a:
/// z = h + (h² - R²)/2a and g² = R² - z², so dz = (1 + h/a) dh - R/a dR and g dg = R dR - z dz.
void putOnGround(tws_msgs::Track& message, const Height& height, const HeightGeometry& place, const Site& site) {
  const double R = message.range, g = place.ground, z = place.z;
  const Eigen::Vector2d radial = Eigen::Vector2d(message.position.x - site.x, message.position.y - site.y).normalized();
  const Eigen::Matrix2d along = radial * radial.transpose();
  const Eigen::Matrix2d map =
      R / g * (1.0 + z / tws::kMeanEarthRadius) * along + g / R * (Eigen::Matrix2d::Identity() - along);
  const Eigen::Vector2d by_height = -z / g * (1.0 + height.height / tws::kMeanEarthRadius) * radial;
  const Eigen::Vector2d over_ground =
      map * Eigen::Vector2d(message.velocity.x, message.velocity.y) + height.climb * by_height;
  message.position.x = site.x + g * radial.x();
  message.position.y = site.y + g * radial.y();
  message.velocity.x = over_ground.x();
  message.velocity.y = over_ground.y();
  message.speed = over_ground.norm();
  if (message.speed > 0.0) message.course = tws::azimuthOf(over_ground);
  mapCovariance(message.covariance, map, height.height_sigma * by_height, height.climb_sigma * by_height);
}

}  // namespace

void setHeight(tws_msgs::Track& message, const Height& height, const Site& site, bool laid_flat) {
  const auto place = placeAt(message.range, height.height);
  if (!place) return;
  const double a = tws::kMeanEarthRadius;
  message.elevation = place->elevation;
  message.position.z = site.z + place->z;
  message.velocity.z = (1.0 + height.height / a) * height.climb - message.range / a * message.range_rate;
  // The antenna's own height: the plane of the frame touches the earth where its origin is.
  message.height = tws::altitudeOverSphere({site.x, site.y, site.z}) + height.height;
  message.height_sigma = height.height_sigma;
  if (laid_flat) putOnGround(message, height, *place, site);
}

}  // namespace adit_tracker
