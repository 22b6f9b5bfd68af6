#include <tws_core/sine_space.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <tws_core/random_test_helpers.h>
#include <tws_core/units.h>

namespace tws {
namespace {

void expectClose(const Eigen::MatrixXd& actual, const Eigen::MatrixXd& expected, double tolerance) {
  EXPECT_LE((actual - expected).norm(), tolerance) << "is\n" << actual << "\nnot\n" << expected;
}

Ruv randomRuv(std::mt19937_64& generator) {
  const double sine = uniform(generator, 0.0, 0.95), turn = uniform(generator, 0.0, 6.283);
  return {uniform(generator, 1e3, 3e5), sine * std::cos(turn), sine * std::sin(turn)};
}

// A wrong sign of u mirrors the picture of the whole array.
TEST(SineSpace, CountsUToTheRightOfBoresightAndVUpwards) {
  expectClose(arrayFromRuv({100.0, 0.0, 0.0}), Eigen::Vector3d(100, 0, 0), 1e-12);
  expectClose(arrayFromRuv({100.0, 0.6, 0.0}), Eigen::Vector3d(80, -60, 0), 1e-12);
  expectClose(arrayFromRuv({100.0, 0.0, 0.28}), Eigen::Vector3d(96, 0, 28), 1e-12);
}

TEST(SineSpace, SolvesATriangleOfWholeNumbers) {
  const Ruv ruv = ruvFromArray({3.0, 4.0, 12.0});  // 3-4-5, then 5-12-13
  EXPECT_DOUBLE_EQ(ruv.range, 13.0);
  EXPECT_DOUBLE_EQ(ruv.u, -4.0 / 13.0);
  EXPECT_DOUBLE_EQ(ruv.v, 12.0 / 13.0);
  EXPECT_EQ(ruvFromArray(Eigen::Vector3d::Zero()).range, 0.0);
}

TEST(SineSpace, ThereAndBackIsTheSamePlace) {
  auto generator = seededGenerator();
  for (int i = 0; i < 10000; ++i) {
    const Ruv ruv = randomRuv(generator), back = ruvFromArray(arrayFromRuv(ruv));
    EXPECT_NEAR(back.range, ruv.range, 1e-9);
    EXPECT_NEAR(back.u, ruv.u, 1e-14);
    EXPECT_NEAR(back.v, ruv.v, 1e-14);
  }
}

// Noise carries measurements over the edge of the visible region; a number made up there would start a track.
TEST(SineSpace, HasNoPlaceOutsideTheVisibleRegion) {
  EXPECT_TRUE(isVisible(0.6, -0.8));
  EXPECT_FALSE(isVisible(0.8, 0.8));
  EXPECT_FALSE(isVisible(std::numeric_limits<double>::quiet_NaN(), 0.0));
  EXPECT_TRUE(std::isnan(arrayFromRuv({100.0, 0.8, 0.8}).x()));
}

// Covariances of tracks come through these derivatives.
TEST(SineSpaceJacobians, AreTheNumericalDerivatives) {
  auto generator = seededGenerator();
  for (int i = 0; i < 1000; ++i) {
    const Ruv at = randomRuv(generator);
    Eigen::Matrix3d numeric;
    const double steps[] = {1.0, 1e-6, 1e-6};
    for (int column = 0; column < 3; ++column) {
      const auto moved = [&](double step) {
        return arrayFromRuv({at.range + (column == 0 ? step : 0.0), at.u + (column == 1 ? step : 0.0),
                             at.v + (column == 2 ? step : 0.0)});
      };
      numeric.col(column) = (moved(steps[column]) - moved(-steps[column])) / (2.0 * steps[column]);
    }
    expectClose(arrayFromRuvJacobian(at), numeric, 1e-6 * numeric.norm());
  }
}

TEST(SineSpaceJacobians, AreInverseToEachOther) {
  auto generator = seededGenerator();
  for (int i = 0; i < 1000; ++i) {
    const Ruv at = randomRuv(generator);
    expectClose(ruvFromArrayJacobian(arrayFromRuv(at)) * arrayFromRuvJacobian(at), Eigen::Matrix3d::Identity(), 1e-9);
  }
}

TEST(ArrayRotation, PutsBoresightLeftAndUpInTheirPlaces) {
  const Eigen::Matrix3d east = enuFromArrayRotation(radians(90.0), 0.0);
  expectClose(east.col(0), Eigen::Vector3d(1, 0, 0), 1e-15);  // boresight east,
  expectClose(east.col(1), Eigen::Vector3d(0, 1, 0), 1e-15);  // left is north,
  expectClose(east.col(2), Eigen::Vector3d(0, 0, 1), 1e-15);
  const Eigen::Matrix3d tilted = enuFromArrayRotation(0.0, radians(30.0));
  expectClose(tilted.col(0), Eigen::Vector3d(0, std::sqrt(0.75), 0.5), 1e-15);
  expectClose(tilted.col(1), Eigen::Vector3d(-1, 0, 0), 1e-15);
  expectClose(tilted.col(2), Eigen::Vector3d(0, -0.5, std::sqrt(0.75)), 1e-15);
}

}  // namespace
}  // namespace tws
