#include <tws_core/sea_level.h>

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/units.h>

namespace tws {
namespace {

// If these fail, a track's height is off by the earth's curve: 3 km at 200 km.

TEST(SeaLevel, ThePlaneOfTheMapRisesAboveTheSea) {
  const SeaLevel unknown;
  const SeaLevel known(Geodetic{radians(48.0), radians(11.0), 0.0});
  EXPECT_NEAR(unknown.heightOf({0.0, 0.0, 100.0}), 100.0, 1e-6);
  // d² / (2 R) with R = 6371 km: 3139 m; R of the ellipsoid at 48° is between 6371 km and 6390 km.
  EXPECT_NEAR(unknown.heightOf({200e3, 0.0, 0.0}), 3139.0, 1.0);
  EXPECT_NEAR(known.heightOf({200e3, 0.0, 0.0}), 3130.0, 5.0);
  EXPECT_TRUE(std::isnan(known.heightOf({0.0, 0.0, std::nan("")})));
}

TEST(SeaLevel, CountsFromTheOriginsAltitude) {
  const SeaLevel high(Geodetic{radians(48.0), radians(11.0), 500.0});
  EXPECT_NEAR(high.heightOf({0.0, 0.0, 20.0}), 520.0, 1e-6);
}

TEST(SeaLevel, APointAtARangeHasTheHeightThatItIsAskedFor) {
  const Eigen::Vector3d from(5000.0, -2000.0, 30.0);
  for (const SeaLevel& sea : {SeaLevel(), SeaLevel(Geodetic{radians(48.0), radians(11.0), 500.0})}) {
    for (const double range : {12e3, 60e3, 250e3}) {
      const Eigen::Vector2d direction(0.6, -0.8);
      const auto z = sea.upAtRange(from, direction, range, 11e3);
      ASSERT_TRUE(z.has_value());
      const double up = *z - from.z(), ground = std::sqrt(range * range - up * up);
      EXPECT_NEAR(sea.heightOf(from + Eigen::Vector3d(ground * direction.x(), ground * direction.y(), up)), 11e3, 1e-3)
          << range;
    }
  }
}

TEST(SeaLevel, NoPointNearerThanItsHeight) {
  EXPECT_FALSE(SeaLevel().upAtRange({0.0, 0.0, 0.0}, {1.0, 0.0}, 9e3, 10e3).has_value());
  EXPECT_FALSE(SeaLevel().upAtRange({0.0, 0.0, 0.0}, {1.0, 0.0}, 9e3, std::nan("")).has_value());
}

}  // namespace
}  // namespace tws
