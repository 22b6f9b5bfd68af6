#include <tws_core/refraction.h>

#include <gtest/gtest.h>

#include <cmath>

#include <Eigen/Core>

namespace tws {
namespace {

// By hand: 0.09 seen at 100 km is 9000 m on the flat earth, and the earth falls away by (100 km)² cos² / (2 · 8494.7
// km) = 583.8 m. A height without it would put a high aircraft half a kilometre too low.
TEST(HeightOf, AddsTheCurvatureOfTheEarth) {
  EXPECT_NEAR(heightOf(0.0, 0.09, 100e3), 9000.0 + 583.8, 1.0);
  EXPECT_NEAR(heightOf(30.0, 0.0, 50e3), 30.0 + 50e3 * 50e3 / (2.0 * 8494.7e3), 0.1);
  EXPECT_NEAR(heightOf(25.0, 1.0, 5000.0), 5025.0, 1e-6);
}

TEST(HeightOf, IsTheInverseOfTheElevation) {
  for (const double radius : {kEffectiveEarthRadius, kMeanEarthRadius}) {
    for (const double height : {0.0, 35.0, 3000.0, 20000.0}) {
      for (const double range : {25e3, 120e3, 350e3}) {
        EXPECT_NEAR(heightOf(35.0, sineOfElevation(35.0, height, range, radius), range, radius), height, 1e-6);
      }
    }
  }
}

// Over the true earth, elevation and range give the place in space: a point at 8000 m, 150 km away on the ground,
// computed from the earth's centre.
TEST(SineOfElevation, OverTheTrueEarthIsThatOfThePlaceInSpace) {
  const double angle = 150e3 / kMeanEarthRadius, radius = kMeanEarthRadius + 8000.0;
  const Eigen::Vector2d place(radius * std::sin(angle), radius * std::cos(angle) - kMeanEarthRadius);
  EXPECT_NEAR(sineOfElevation(0.0, 8000.0, place.norm(), kMeanEarthRadius), place.y() / place.norm(), 1e-9);
}

// By hand: near the sea 315 millionths of the way; straight up the integral of the exponential, 315e-6 · 7350 m ·
// (1 - exp(-20 / 7.35)) = 2.1629 m. The far one by the trapezium rule in 100 000 steps.
TEST(AirDelay, IsTheIntegralOfTheRefractivityAlongTheRay) {
  EXPECT_NEAR(airDelay(0.0, 0.0, 10e3), 3.15, 1e-3);
  EXPECT_NEAR(airDelay(0.0, 20e3, 20e3), 2.1629, 1e-4);
  EXPECT_NEAR(airDelay(25.0, 10e3, 400e3), 84.9111, 1e-3);
}

}  // namespace
}  // namespace tws
