#include <tws_core/earth_plane.h>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include <tws_core/angles.h>
#include <tws_core/units.h>

namespace tws {
namespace {

// If these fail, sites place one aircraft kilometres apart: it becomes two tracks, at wrong places.

const Geodetic kOrigin{radians(51.0), radians(10.0), 120.0};
constexpr double kTurn = 0.03;

/// The truth of all tests: places on earth by LocalFrame, which another test holds against GeographicLib.
struct World {
  Geodetic first{radians(49.5), radians(8.0), 300.0};  // where the plane's origin is
  LocalFrame map{kOrigin};
  Eigen::Vector3d at = map.toEnu(first);
  EarthPlane plane{kOrigin, at, kTurn};

  Eigen::Vector3d onPlane(const Geodetic& place) const {
    const Eigen::Vector3d d = map.toEnu(place) - at;
    const double c = std::cos(kTurn), s = std::sin(kTurn);
    return {c * d.x() + s * d.y(), c * d.y() - s * d.x(), d.z()};
  }
  /// As the site's transform gives it: yaw of its axes against those of the plane.
  SiteFrame frameOf(const Geodetic& site) const {
    const Eigen::Vector3d p = onPlane(site);
    const LocalFrame local(site);
    const Eigen::Vector3d east = map.ecefFromEnuRotation().transpose() * local.ecefFromEnuRotation().col(0);
    return {p.x(), p.y(), std::atan2(east.y(), east.x()) - kTurn, p.z()};
  }
  struct Polar {
    double range, azimuth;
  };
  static Polar measured(const Geodetic& site, const Geodetic& target) {
    const Eigen::Vector3d line = LocalFrame(site).toEnu(target);
    return {line.norm(), wrapTwoPi(std::atan2(line.x(), line.y()))};
  }
};

Geodetic place(double latitude, double longitude, double height) {
  return {radians(latitude), radians(longitude), height};
}

/// Sites up to 500 km from the origin to all sides and targets within 450 km of each: 1000 km across.
template <class Use>
void forAll(const Use& use) {
  const World world;
  for (const auto& site : {place(49.5, 8.0, 300.0), place(46.6, 8.3, 1800.0), place(55.4, 11.0, 40.0),
                           place(51.2, 3.1, 20.0), place(50.6, 16.8, 700.0)}) {
    for (const double north : {-3.9, -1.1, 0.0, 0.4, 3.8})
      for (const double east : {-5.0, -0.9, 0.3, 4.7})
        for (const double height : {0.0, 3000.0, 11000.0}) {
          const Geodetic target{site.latitude + radians(north), site.longitude + radians(east), height + 500.0};
          use(world, site, target);
        }
  }
}

TEST(EarthPlane, PlotsOfAllSitesLieWhereTheTargetIsOverAThousandKilometres) {
  double worst = 0.0, flat = 0.0;
  forAll([&](const World& world, const Geodetic& site, const Geodetic& target) {
    const EarthSite there(world.plane, world.frameOf(site));
    const World::Polar seen = World::measured(site, target);
    const PlanarPosition found = there.placeOf(seen.range, seen.azimuth, 50.0, 0.002, target.altitude).place;
    const Eigen::Vector3d truth = world.onPlane(target);
    worst = std::max(worst, std::hypot(found.x - truth.x(), found.y - truth.y()));
    // What was done before: slant range and height above one plane.
    const SiteFrame frame = world.frameOf(site);
    const double ground = std::sqrt(seen.range * seen.range - std::pow(target.altitude, 2));
    const double azimuth = frame.onPlane(seen.azimuth);
    flat = std::max(flat, std::hypot(frame.x + ground * std::sin(azimuth) - truth.x(),
                                     frame.y + ground * std::cos(azimuth) - truth.y()));
  });
  EXPECT_LT(worst, 1.0);
  EXPECT_GT(flat, 1000.0);  // the same data do tell a round earth
  RecordProperty("worst_mm", static_cast<int>(1e3 * worst));
  RecordProperty("flat_m", static_cast<int>(flat));
}

TEST(EarthPlane, ARadarSeesAPointOfThePlaneWhereItIs) {
  forAll([&](const World& world, const Geodetic& site, const Geodetic& target) {
    const EarthSite there(world.plane, world.frameOf(site));
    const Eigen::Vector3d p = world.onPlane(target);
    const SiteView view = there.view(p.x(), p.y(), target.altitude);
    const World::Polar seen = World::measured(site, target);
    EXPECT_NEAR(view.range, seen.range, 0.2);
    EXPECT_NEAR(angularDifference(view.azimuth, seen.azimuth), 0.0, 1e-6);
    EXPECT_NEAR(world.plane.zAt(p.x(), p.y(), target.altitude), p.z(), 0.2);
    EXPECT_NEAR(world.plane.heightOf(p), target.altitude, 1e-5);
    EXPECT_NEAR(there.height(), site.altitude, 1e-5);
  });
}

// Without the latitude a tracker must still join its sites: they know of their places from each other only.
TEST(EarthPlane, ATrackerThatDoesNotKnowItsLatitudeIsGoodToTwentyMetres) {
  double worst = 0.0;
  for (const double latitude : {1.0, 30.0, 60.0, 80.0}) {
    const Geodetic origin = place(latitude, 10.0, 0.0);
    const LocalFrame map(origin);
    const EarthPlane plane;
    for (const double away : {-4.0, -2.0, 2.0, 4.0}) {
      const Geodetic site = place(latitude + away, 10.0, 100.0);
      const Eigen::Vector3d p = map.toEnu(site);
      const EarthSite there(plane, {p.x(), p.y(), 0.0, p.z()});
      for (const double further : {-2.5, 2.5}) {
        const Geodetic target = place(latitude + away + further, 10.0, 10000.0);
        const World::Polar seen = World::measured(site, target);
        const PlanarPosition found = there.placeOf(seen.range, seen.azimuth, 50.0, 0.002, target.altitude).place;
        const Eigen::Vector3d truth = map.toEnu(target);
        worst = std::max(worst, std::hypot(found.x - truth.x(), found.y - truth.y()));
      }
    }
  }
  EXPECT_LT(worst, 20.0);
  RecordProperty("worst_m", static_cast<int>(worst));
}

/// What placeOf says of errors is what they do.
TEST(EarthPlane, CovarianceAndHeightMoveAPlaceAsTheySay) {
  forAll([&](const World& world, const Geodetic& site, const Geodetic& target) {
    const EarthSite there(world.plane, world.frameOf(site));
    const World::Polar seen = World::measured(site, target);
    const double height = target.altitude, sr = 50.0, sa = 1e-4;
    if (seen.range < 20e3) return;
    const auto at = [&](double r, double a, double h) {
      const PlanarPosition p = there.placeOf(r, a, sr, sa, h).place;
      return Eigen::Vector2d(p.x, p.y);
    };
    const Eigen::Vector2d by_range =
        0.5 * (at(seen.range + sr, seen.azimuth, height) - at(seen.range - sr, seen.azimuth, height));
    const Eigen::Vector2d by_azimuth =
        0.5 * (at(seen.range, seen.azimuth + sa, height) - at(seen.range, seen.azimuth - sa, height));
    const Eigen::Vector2d by_height =
        (at(seen.range, seen.azimuth, height + 50.0) - at(seen.range, seen.azimuth, height - 50.0)) / 100.0;
    const PlaceAtHeight z = there.placeOf(seen.range, seen.azimuth, sr, sa, height);
    const Eigen::Matrix2d covariance = by_range * by_range.transpose() + by_azimuth * by_azimuth.transpose();
    const double scale = 0.01 * covariance.trace();
    EXPECT_NEAR(z.place.covariance.xx, covariance(0, 0), scale);
    EXPECT_NEAR(z.place.covariance.xy, covariance(0, 1), scale);
    EXPECT_NEAR(z.place.covariance.yy, covariance(1, 1), scale);
    EXPECT_NEAR(z.x_per_height, by_height.x(), 2e-3 + 0.01 * by_height.norm());
    EXPECT_NEAR(z.y_per_height, by_height.y(), 2e-3 + 0.01 * by_height.norm());
    const Eigen::Vector2d seen_so = there.perHeight(there.view(z.place.x, z.place.y, height));
    EXPECT_NEAR(z.x_per_height, seen_so.x(), 1e-4);
    EXPECT_NEAR(z.y_per_height, seen_so.y(), 1e-4);
    // And the way back.
    const Eigen::Matrix2d ground = there.onGround(z.place.x, z.place.y, height);
    const SiteView a = there.view(z.place.x, z.place.y, height),
                   b = there.view(z.place.x + 10.0, z.place.y - 20.0, height);
    const Eigen::Vector2d moved = ground * Eigen::Vector2d(10.0, -20.0);
    EXPECT_NEAR(b.east - a.east, moved.x(), 1e-3);
    EXPECT_NEAR(b.north - a.north, moved.y(), 1e-3);
  });
}

TEST(EarthPlane, WhatFliesHigherThanItsRangeIsSeenSteeplyAndDoesNotFail) {
  const World world;
  const EarthSite there(world.plane, world.frameOf(world.first));
  for (const double range : {1.0, 500.0, 8e3}) {
    const PlaceAtHeight z = there.placeOf(range, 1.0, 50.0, 0.002, 10e3);
    EXPECT_LT(std::hypot(z.place.x, z.place.y), range);
    EXPECT_TRUE(std::isfinite(z.x_per_height) && std::isfinite(z.place.covariance.determinant()));
  }
  EXPECT_GE(there.view(0.0, 0.0, 300.0).range, 1.0);
}

TEST(EarthPlane, NoPlaceOnEarthIsRefused) { EXPECT_THROW(EarthPlane(Geodetic{2.0, 0.0, 0.0}), std::invalid_argument); }

}  // namespace
}  // namespace tws
