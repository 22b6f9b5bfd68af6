// Places on earth against a well-kept library (GeographicLib). If this fails, tracks and sites lie in the wrong place
// on every map but ours.
#include <gtest/gtest.h>

#include <GeographicLib/LocalCartesian.hpp>
#include <cmath>

#include <tws_core/earth_plane.h>
#include <tws_core/geodesy.h>
#include <tws_core/random_test_helpers.h>
#include <tws_core/units.h>

namespace tws {
namespace {

constexpr double kMillimetre = 1e-3;

Geodetic anyPlace(std::mt19937_64& generator, double lowest, double highest) {
  return {uniform(generator, -kPi / 2, kPi / 2), uniform(generator, -kPi, kPi), uniform(generator, lowest, highest)};
}

Eigen::Vector3d byGeographicLib(const GeographicLib::LocalCartesian& frame, const Geodetic& place) {
  Eigen::Vector3d enu;
  frame.Forward(degrees(place.latitude), degrees(place.longitude), place.altitude, enu.x(), enu.y(), enu.z());
  return enu;
}

TEST(GeodesyPeer, GeocentricPlacesAgree) {
  const GeographicLib::Geocentric& peer = GeographicLib::Geocentric::WGS84();
  auto generator = seededGenerator();
  for (int i = 0; i < 10000; ++i) {
    const Geodetic place = anyPlace(generator, -10e3, 100e3);
    Eigen::Vector3d its;
    peer.Forward(degrees(place.latitude), degrees(place.longitude), place.altitude, its.x(), its.y(), its.z());
    EXPECT_LE((ecefFromGeodetic(place) - its).norm(), kMillimetre);
    double latitude = 0.0, longitude = 0.0, altitude = 0.0;
    peer.Reverse(its.x(), its.y(), its.z(), latitude, longitude, altitude);
    const Geodetic ours = geodeticFromEcef(its);
    EXPECT_NEAR(ours.latitude, radians(latitude), kMillimetre / kSemiMajorAxis);
    EXPECT_NEAR(ours.altitude, altitude, kMillimetre);
    EXPECT_NEAR(angularDifference(ours.longitude, radians(longitude)) * std::cos(ours.latitude), 0.0,
                kMillimetre / kSemiMajorAxis);
  }
}

TEST(GeodesyPeer, LocalFramesAgreeOverAThousandKilometres) {
  auto generator = seededGenerator();
  for (int i = 0; i < 10000; ++i) {
    const Geodetic origin{uniform(generator, -1.4, 1.4), uniform(generator, -kPi, kPi), uniform(generator, 0, 3000)};
    const Geodetic place{origin.latitude + uniform(generator, -0.16, 0.16),
                         origin.longitude + uniform(generator, -0.16, 0.16), uniform(generator, 0, 20e3)};
    const GeographicLib::LocalCartesian peer(degrees(origin.latitude), degrees(origin.longitude), origin.altitude);
    EXPECT_LE((LocalFrame(origin).toEnu(place) - byGeographicLib(peer, place)).norm(), kMillimetre);
  }
}

// The plane knows the height from a closed form; over a thousand kilometres it may differ from the ellipsoid's own.
TEST(GeodesyPeer, ThePlaneLiesOverTheSameEllipsoid) {
  auto generator = seededGenerator();
  for (int i = 0; i < 10000; ++i) {
    const Geodetic origin{uniform(generator, -1.4, 1.4), uniform(generator, -kPi, kPi), 0.0};
    const Geodetic place{origin.latitude + uniform(generator, -0.1, 0.1),
                         origin.longitude + uniform(generator, -0.1, 0.1), uniform(generator, 0, 20e3)};
    const GeographicLib::LocalCartesian peer(degrees(origin.latitude), degrees(origin.longitude), 0.0);
    const Eigen::Vector3d point = byGeographicLib(peer, place);
    EXPECT_NEAR(EarthPlane(origin).zAt(point.x(), point.y(), place.altitude), point.z(), 0.15);
  }
}

}  // namespace
}  // namespace tws
