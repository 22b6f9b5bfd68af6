#include "epoch.h"

#include <gtest/gtest.h>

#include <cmath>

#include "epoch_test_helpers.h"

namespace track_evaluation {
namespace {

// If one of these fails, tracks of 2-D radars look wrong by kilometres near the site.

const Eigen::Vector3d kSite(100.0, 200.0, 0.0);

TEST(Epoch, OnTheSlantPlaneATargetLiesAtItsSlantRangeAndAzimuth) {
  // 3 km east and 4 km up: slant range 5 km.
  const PlanarState state = onSlantPlane(kSite + Eigen::Vector3d(3000, 0, 4000), {0, 0, 0}, kSite);
  EXPECT_NEAR(state.position.x(), 100.0 + 5000.0, 1e-9);
  EXPECT_NEAR(state.position.y(), 200.0, 1e-9);
}

TEST(Epoch, OnTheSlantPlaneVelocityIsTheDerivativeOfPosition) {
  const Eigen::Vector3d position(3000, -1000, 4000), velocity(150, 80, -20);
  const double step = 1e-3;
  const Eigen::Vector2d before = onSlantPlane(position - step * velocity, velocity, kSite).position;
  const Eigen::Vector2d after = onSlantPlane(position + step * velocity, velocity, kSite).position;
  const PlanarState state = onSlantPlane(position, velocity, kSite);
  EXPECT_NEAR((state.velocity - (after - before) / (2.0 * step)).norm(), 0.0, 1e-4);
}

TEST(Epoch, StraightAboveTheSiteThereIsNoAzimuthAndNoNaN) {
  const PlanarState state = onSlantPlane(kSite + Eigen::Vector3d(0, 0, 5000), {100, 0, 0}, kSite);
  EXPECT_EQ(state.position, kSite.head<2>());
  EXPECT_FALSE(state.velocity.hasNaN());
}

TEST(Epoch, ATrackWithoutHeightIsComparedOnTheSlantPlane) {
  Epoch epoch;
  epoch.truths = {truthAt(1, 3000, 0)};
  epoch.truths[0].slant = still(5000, 0);
  epoch.tracks = {trackAt(5, 5000, 0), trackAt(6, 5000, 0)};
  epoch.tracks[0].has_height = false;
  Distances distances;
  distances.compute(epoch);
  EXPECT_EQ(distances.at(0, 0), 0.0);
  EXPECT_EQ(distances.at(0, 1), 2000.0);
}

}  // namespace
}  // namespace track_evaluation
