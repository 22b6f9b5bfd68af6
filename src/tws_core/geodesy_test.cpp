#include <tws_core/geodesy.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>
#include <tws_core/units.h>

namespace tws {
namespace {

double fromDms(double degrees, double minutes, double seconds) {
  return radians(degrees + minutes / 60.0 + seconds / 3600.0);
}

// The example of IOGP Guidance Note 7-2 (EPSG methods 9602 and 9837), printed to the millimetre.
const Geodetic kExample{fromDms(53, 48, 33.820), fromDms(2, 7, 46.380), 73.0};

// Without it real sites and recorded trajectories would be drawn in the wrong place.
TEST(Geodesy, ReproducesTheGeocentricExampleOfTheEpsgGuidanceNote) {
  const Eigen::Vector3d ecef = ecefFromGeodetic(kExample);
  EXPECT_NEAR(ecef.x(), 3771793.968, 1e-3);
  EXPECT_NEAR(ecef.y(), 140253.342, 1e-3);
  EXPECT_NEAR(ecef.z(), 5124304.349, 1e-3);
}

// If this fails, an aircraft that is far away is given a height that is wrong by kilometres.
TEST(Geodesy, KnowsTheAltitudeFarFromAnOriginOfUnknownPlace) {
  auto generator = seededGenerator();
  for (int i = 0; i < 200; ++i) {
    const Geodetic origin{uniform(generator, -1.4, 1.4), 0.3, 0.0};
    const LocalFrame frame(origin);
    const double distance = uniform(generator, 0.0, 200e3), azimuth = uniform(generator, 0.0, kTwoPi);
    const Eigen::Vector3d enu(distance * std::sin(azimuth), distance * std::cos(azimuth), 5000.0);
    const double altitude = frame.toGeodetic(enu).altitude;
    EXPECT_NEAR(altitudeOverSphere(enu), altitude, 0.1 + 0.006 * (altitude - 5000.0));
  }
}

TEST(LocalFrame, ReproducesTheTopocentricExampleOfTheEpsgGuidanceNote) {
  const LocalFrame frame({radians(55.0), radians(5.0), 200.0});
  const Eigen::Vector3d enu = frame.toEnu(kExample);
  EXPECT_NEAR(enu.x(), -189013.869, 1e-3);
  EXPECT_NEAR(enu.y(), -128642.040, 1e-3);
  EXPECT_NEAR(enu.z(), -4220.171, 1e-3);
}

TEST(Geodesy, HasTheEllipsoidsAxesAtTheEquatorAndThePoles) {
  EXPECT_LE((ecefFromGeodetic({0.0, 0.0, 0.0}) - Eigen::Vector3d(6378137.0, 0, 0)).norm(), 1e-8);
  EXPECT_LE((ecefFromGeodetic({kPi / 2, 0.0, 0.0}) - Eigen::Vector3d(0, 0, 6356752.314245)).norm(), 1e-6);
  const Geodetic south = geodeticFromEcef({0.0, 0.0, -6356752.314245 - 1000.0});
  EXPECT_DOUBLE_EQ(south.latitude, -kPi / 2);
  EXPECT_NEAR(south.altitude, 1000.0, 1e-6);
}

TEST(Geodesy, GivesBackEveryPlaceOnEarthFromTheDeepSeaToOrbit) {
  auto generator = seededGenerator();
  for (int i = 0; i < 10000; ++i) {
    const Geodetic place{uniform(generator, -kPi / 2, kPi / 2), uniform(generator, -kPi, kPi),
                         uniform(generator, -1e5, 1e6)};
    const Geodetic back = geodeticFromEcef(ecefFromGeodetic(place));
    EXPECT_NEAR(back.altitude, place.altitude, 1e-6);
    EXPECT_LE((ecefFromGeodetic(back) - ecefFromGeodetic(place)).norm(), 1e-6);
    EXPECT_NEAR(back.latitude, place.latitude, 1e-13);
  }
}

TEST(LocalFrame, ReturnsToTheSamePointWithinAMicrometre400KilometresAway) {
  auto generator = seededGenerator();
  for (int i = 0; i < 1000; ++i) {
    const LocalFrame frame(
        {uniform(generator, -1.57, 1.57), uniform(generator, -kPi, kPi), uniform(generator, 0, 3000)});
    for (int j = 0; j < 10; ++j) {
      const Eigen::Vector3d enu(uniform(generator, -4e5, 4e5), uniform(generator, -4e5, 4e5),
                                uniform(generator, -2e3, 2e4));
      EXPECT_LE((frame.toEnu(frame.toGeodetic(enu)) - enu).norm(), 1e-6);
    }
  }
}

TEST(LocalFrame, PointsEastNorthAndUp) {
  const Geodetic origin{radians(60.0), radians(179.9999), 50.0};
  const LocalFrame frame(origin);
  EXPECT_LE(frame.toEnu(origin).norm(), 1e-8);
  EXPECT_NEAR(frame.toEnu({origin.latitude, origin.longitude, 1050.0}).z(), 1000.0, 1e-8);
  EXPECT_GT(frame.toEnu({origin.latitude + 1e-4, origin.longitude, 50.0}).y(), 600.0);
  // East across the antimeridian, where the longitude jumps to -180°.
  EXPECT_NEAR(frame.toEnu({origin.latitude, radians(-179.9999), 50.0}).x(), 11.16, 0.01);
  EXPECT_LT(frame.toGeodetic({100.0, 0.0, 0.0}).longitude, 0.0);
}

TEST(LocalFrame, RefusesAnOriginThatIsNoPlaceOnEarth) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(LocalFrame({1.6, 0.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(LocalFrame({kNaN, 0.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(LocalFrame({0.0, kNaN, 0.0}), std::invalid_argument);
  EXPECT_THROW(LocalFrame({0.0, 0.0, kNaN}), std::invalid_argument);
}

}  // namespace
}  // namespace tws
