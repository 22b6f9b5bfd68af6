#include <tws_core/geometry.h>

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>
#include <tws_core/units.h>

namespace tws {
namespace {

void expectNear(const Eigen::VectorXd& actual, const Eigen::VectorXd& expected, double tolerance) {
  EXPECT_LE((actual - expected).norm(), tolerance) << "is " << actual.transpose() << ", not " << expected.transpose();
}

// Azimuth counts clockwise from north; the mathematicians' sense would mirror the whole picture.
TEST(EnuFromPolar, PutsTheFourQuartersOfTheCompassInTheirPlaces) {
  expectNear(enuFromPolar({100.0, radians(0.0), 0.0}), Eigen::Vector3d(0, 100, 0), 1e-12);
  expectNear(enuFromPolar({100.0, radians(90.0), 0.0}), Eigen::Vector3d(100, 0, 0), 1e-12);
  expectNear(enuFromPolar({100.0, radians(180.0), 0.0}), Eigen::Vector3d(0, -100, 0), 1e-12);
  expectNear(enuFromPolar({100.0, radians(270.0), 0.0}), Eigen::Vector3d(-100, 0, 0), 1e-12);
  expectNear(enuFromPolar({100.0, radians(90.0), radians(30.0)}), Eigen::Vector3d(86.60254037844386, 0, 50), 1e-12);
}

TEST(PolarFromEnu, SolvesATriangleOfWholeNumbers) {
  const Polar polar = polarFromEnu({-3.0, -4.0, 12.0});  // 3-4-5 on the ground, 5-12-13 upright
  EXPECT_DOUBLE_EQ(polar.range, 13.0);
  EXPECT_DOUBLE_EQ(polar.azimuth, kPi + std::atan(0.75));
  EXPECT_DOUBLE_EQ(polar.elevation, std::atan(12.0 / 5.0));
}

TEST(PolarFromEnu, HasAnAnswerOverheadAndAtTheRadar) {
  const Polar overhead = polarFromEnu({0.0, 0.0, 500.0});
  EXPECT_EQ(overhead.azimuth, 0.0);
  EXPECT_DOUBLE_EQ(overhead.elevation, kPi / 2);
  const Polar here = polarFromEnu(Eigen::Vector3d::Zero());
  EXPECT_EQ(here.range, 0.0);
  EXPECT_EQ(here.azimuth, 0.0);
  EXPECT_EQ(here.elevation, 0.0);
}

TEST(PolarFromEnu, UndoesEnuFromPolar) {
  auto generator = seededGenerator();
  for (int i = 0; i < 10000; ++i) {
    const Polar polar{uniform(generator, 1.0, 4e5), uniform(generator, 0.0, kTwoPi), uniform(generator, -1.5, 1.5)};
    const Polar back = polarFromEnu(enuFromPolar(polar));
    EXPECT_NEAR(back.range, polar.range, 1e-9);
    EXPECT_NEAR(angularDifference(back.azimuth, polar.azimuth), 0.0, 1e-13);
    EXPECT_NEAR(back.elevation, polar.elevation, 1e-13);
    EXPECT_TRUE(back.azimuth >= 0.0 && back.azimuth < kTwoPi);
  }
}

// Rates with a wrong sign send every predicted position the wrong way.
TEST(EnuVelocity, IsTheNumericalDerivativeOfThePosition) {
  auto generator = seededGenerator();
  for (int i = 0; i < 1000; ++i) {
    const Polar at{uniform(generator, 1e3, 1e5), uniform(generator, 0.0, kTwoPi), uniform(generator, -1.4, 1.4)};
    const PolarRates rates{uniform(generator, -300, 300), uniform(generator, -0.01, 0.01),
                           uniform(generator, -0.01, 0.01)};
    const auto moved = [&](double t) {
      return enuFromPolar(
          {at.range + rates.range * t, at.azimuth + rates.azimuth * t, at.elevation + rates.elevation * t});
    };
    constexpr double kStep = 1e-3;
    expectNear(enuVelocity(at, rates), (moved(kStep) - moved(-kStep)) / (2 * kStep), 1e-4);
  }
}

TEST(PolarRatesFromVelocity, UndoEnuVelocity) {
  auto generator = seededGenerator();
  for (int i = 0; i < 10000; ++i) {
    const Polar at{uniform(generator, 1e3, 1e5), uniform(generator, 0.0, kTwoPi), uniform(generator, -1.4, 1.4)};
    const PolarRates rates{uniform(generator, -300, 300), uniform(generator, -0.01, 0.01),
                           uniform(generator, -0.01, 0.01)};
    const PolarRates back = polarRates(enuFromPolar(at), enuVelocity(at, rates));
    EXPECT_NEAR(back.range, rates.range, 1e-9);
    EXPECT_NEAR(back.azimuth, rates.azimuth, 1e-13);
    EXPECT_NEAR(back.elevation, rates.elevation, 1e-13);
  }
}

TEST(PolarRatesFromVelocity, AreFiniteWhereAnglesHaveNoRate) {
  const PolarRates overhead = polarRates({0.0, 0.0, 1000.0}, {30.0, 40.0, -5.0});
  EXPECT_DOUBLE_EQ(overhead.range, -5.0);
  EXPECT_EQ(overhead.azimuth, 0.0);
  EXPECT_EQ(overhead.elevation, 0.0);
  EXPECT_DOUBLE_EQ(polarRates(Eigen::Vector3d::Zero(), {3.0, 4.0, 12.0}).range, 13.0);
}

TEST(FlatEarth, ConvertsBetweenSlantAndGroundRange) {
  EXPECT_DOUBLE_EQ(groundRange(13000.0, 5000.0), 12000.0);
  EXPECT_DOUBLE_EQ(groundRange(13000.0, -5000.0), 12000.0);
  EXPECT_DOUBLE_EQ(slantRange(12000.0, 5000.0), 13000.0);
}

// Noise puts measured ranges below the height of a target overhead; a NaN would spread through the track.
TEST(FlatEarth, GivesZeroForASlantRangeBelowTheHeight) {
  EXPECT_EQ(groundRange(4999.0, 5000.0), 0.0);
  EXPECT_EQ(groundRange(5000.0, 5000.0), 0.0);
  EXPECT_EQ(groundRange(-1.0, 0.0), 0.0);
}

TEST(Planar, AgreesWithTheThreeDimensionalConversionsAtZeroElevation) {
  auto generator = seededGenerator();
  for (int i = 0; i < 1000; ++i) {
    const double range = uniform(generator, 1.0, 4e5), azimuth = uniform(generator, 0.0, kTwoPi);
    const double range_rate = uniform(generator, -300, 300), azimuth_rate = uniform(generator, -0.01, 0.01);
    expectNear(planarFromPolar(range, azimuth), enuFromPolar({range, azimuth, 0.0}).head<2>(), 1e-9);
    expectNear(planarVelocity(range, azimuth, range_rate, azimuth_rate),
               enuVelocity({range, azimuth, 0.0}, {range_rate, azimuth_rate, 0.0}).head<2>(), 1e-9);
  }
}

TEST(Planar, ReadsTheCourseClockwiseFromNorth) {
  EXPECT_DOUBLE_EQ(azimuthOf({1.0, 1.0}), kPi / 4);
  EXPECT_DOUBLE_EQ(azimuthOf({-1.0, 0.0}), 1.5 * kPi);
  EXPECT_EQ(azimuthOf({0.0, 0.0}), 0.0);
  EXPECT_EQ(azimuthOf({-1e-300, 1.0}), 0.0);
}

}  // namespace
}  // namespace tws
