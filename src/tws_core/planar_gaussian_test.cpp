#include <tws_core/planar_gaussian.h>

#include <gtest/gtest.h>

#include <tws_core/angles.h>

namespace tws {
namespace {

TEST(PlanarPosition, TurnsRangeAndAzimuthErrorsIntoThePlane) {
  // Due east: range is x, cross-range is y.
  const PlanarPosition east = planarMeasurement(100e3, kPi / 2.0, 50.0, 0.005);
  EXPECT_NEAR(east.x, 100e3, 1e-6);
  EXPECT_NEAR(east.y, 0.0, 1e-6);
  EXPECT_NEAR(east.covariance.xx, 2500.0, 1e-6);
  EXPECT_NEAR(east.covariance.yy, 250000.0, 1e-6);
  EXPECT_NEAR(east.covariance.xy, 0.0, 1e-6);
  // North-east: both mixed, xy = (along - cross) / 2.
  const PlanarPosition between = planarMeasurement(100e3, kPi / 4.0, 50.0, 0.005);
  EXPECT_NEAR(between.covariance.xx, 126250.0, 1e-6);
  EXPECT_NEAR(between.covariance.xy, -123750.0, 1e-6);
}

TEST(Symmetric2, GivesTheSquaredDistanceInStandardDeviations) {
  EXPECT_DOUBLE_EQ((Symmetric2{4.0, 0.0, 9.0}).mahalanobis(4.0, 3.0), 5.0);
  // [2 1; 1 2]⁻¹ = [2 -1; -1 2] / 3
  EXPECT_DOUBLE_EQ((Symmetric2{2.0, 1.0, 2.0}).mahalanobis(1.0, 1.0), 2.0 / 3.0);
}

}  // namespace
}  // namespace tws
