#include "propagation.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/units.h>

namespace radar_sim {
namespace {

// The well-known rule of radar operators: horizon [km] = 4.12 sqrt(height [m]). Low aircraft must not be seen through
// the earth.
TEST(Horizon, FollowsTheFourThirdsRule) {
  EXPECT_NEAR(horizonDistance(100.0), 41.2e3, 0.1e3);
  EXPECT_NEAR(horizonDistance(10000.0), 412.0e3, 1.0e3);
  EXPECT_FALSE(isBeyondHorizon(25.0, 1000.0, 150e3));  // 20.6 km + 130.3 km
  EXPECT_TRUE(isBeyondHorizon(25.0, 1000.0, 152e3));
}

// By hand: 9000 m up at 100 km. Flat earth gives 0.09; the bulge takes 100 km / (2 · 8494.7 km) = 0.00589 of it, and
// the square of the rise, 9000² / (2 · 8494.7 km · 100 km), adds 0.00005.
TEST(Elevation, IsLoweredByTheCurvatureOfTheEarth) {
  EXPECT_NEAR(sineOfElevation(0.0, 9000.0, 100e3), 0.09 - 0.00589 + 0.00005, 2e-5);
  EXPECT_NEAR(sineOfElevation(30.0, 30.0, 50e3), -50e3 / (2.0 * 8494.7e3), 1e-6);
  EXPECT_DOUBLE_EQ(sineOfElevation(0.0, 5000.0, 5000.0), 1.0);
}

double lobing(double height, double wavelength, double elevation_deg, double reflection = 1.0) {
  return propagationFactor(height, wavelength, std::sin(tws::radians(elevation_deg)), 1.0, 1.0, reflection);
}

// Two radars fade at different times: this is why the report uses two.
// By hand, h = 25 m and λ = 0.25 m: nulls at sin e = n λ/(2h) = 0.005 n, that is 0.28648° and 0.57297°; maxima half
// way, 0.14324°. With h = 40 m, λ = 0.1 m: nulls each 0.00125, 0.07162°.
TEST(Lobing, HasItsNullsAndMaximaAtTheHandComputedElevations) {
  EXPECT_NEAR(lobing(25.0, 0.25, 0.28648), 0.0, 1e-6);
  EXPECT_NEAR(lobing(25.0, 0.25, 0.57297), 0.0, 1e-6);
  EXPECT_NEAR(lobing(25.0, 0.25, 0.14324), 4.0, 1e-6);
  EXPECT_NEAR(lobing(25.0, 0.25, 0.42972), 4.0, 1e-6);
  EXPECT_NEAR(lobing(40.0, 0.1, 0.07162), 0.0, 1e-6);
  EXPECT_NEAR(lobing(40.0, 0.1, 0.03581), 4.0, 1e-6);
  EXPECT_GT(lobing(40.0, 0.1, 0.28648 + 0.03581), 3.9);  // where the other radar has its null
}

TEST(Lobing, IsShallowOverARoughSea) {
  EXPECT_NEAR(lobing(25.0, 0.25, 0.28648, 0.6), 0.4 * 0.4, 1e-5);
  EXPECT_NEAR(lobing(25.0, 0.25, 0.14324, 0.6), 1.6 * 1.6, 1e-5);
  EXPECT_DOUBLE_EQ(lobing(25.0, 0.25, 0.14324, 0.0), 1.0);
}

TEST(Lobing, OverAMirrorFadesTowardsTheHorizon) {
  EXPECT_NEAR(lobing(25.0, 0.25, 0.0), 0.0, 1e-12);
  EXPECT_NEAR(lobing(25.0, 0.25, -0.1), 0.0, 1e-12);
}

}  // namespace
}  // namespace radar_sim
