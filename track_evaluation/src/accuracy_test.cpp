#include "accuracy.h"

#include <gtest/gtest.h>

#include <cmath>

#include "epoch_test_helpers.h"

namespace track_evaluation {
namespace {

// If one of these fails, a tracker's errors and the honesty of its covariances cannot be measured.

MetricList reported(const Accuracy& accuracy) {
  MetricList metrics;
  accuracy.report(metrics);
  return metrics;
}

/// A truth flying north-east at 10 m/s, a track 3 m ahead and 4 m to its left.
std::pair<TruthState, TrackState> aheadAndLeft() {
  TruthState truth = truthAt(1, 0, 0);
  const double half = std::sqrt(0.5);
  truth.ground.velocity = {10.0 * half, 10.0 * half};
  TrackState track = trackAt(5, half * (3.0 - 4.0), half * (3.0 + 4.0));
  track.state.velocity = truth.ground.velocity;
  return {truth, track};
}

TEST(Accuracy, SplitsTheErrorAlongAndAcrossTheCourse) {
  Accuracy accuracy(1.0);
  const auto [truth, track] = aheadAndLeft();
  accuracy.add(truth, track);
  EXPECT_NEAR(valueOf(reported(accuracy), "rms_pos_m"), 5.0, 1e-12);
  EXPECT_NEAR(valueOf(reported(accuracy), "rms_along_m"), 3.0, 1e-12);
  EXPECT_NEAR(valueOf(reported(accuracy), "rms_across_m"), 4.0, 1e-12);
  EXPECT_NEAR(valueOf(reported(accuracy), "rms_vel_mps"), 0.0, 1e-12);
}

TEST(Accuracy, NormalisesTheErrorByTheCovariance) {
  Accuracy accuracy(1.0);
  TrackState track = trackAt(5, 3, 4);
  track.state.velocity = {6.0, 0.0};
  track.covariance = Eigen::Vector4d(9.0, 4.0, 36.0, 1.0).asDiagonal();
  accuracy.add(truthAt(1, 0, 0), track);
  // 9 / 9 + 16 / 4 = 5; with the velocity 36 / 36 more.
  EXPECT_NEAR(valueOf(reported(accuracy), "nees_position"), 5.0, 1e-12);
  EXPECT_NEAR(valueOf(reported(accuracy), "nees_state"), 6.0, 1e-12);
}

TEST(Accuracy, JudgesNoOldAndNoImpossibleCovariance) {
  Accuracy accuracy(1.0);
  TrackState track = trackAt(5, 3, 4);
  track.covariance = Eigen::Vector4d(9.0, -4.0, 36.0, 1.0).asDiagonal();
  accuracy.add(truthAt(1, 0, 0), track);
  track.covariance = Eigen::Matrix4d::Identity();
  track.age = 1.5;
  accuracy.add(truthAt(1, 0, 0), track);
  EXPECT_TRUE(std::isnan(valueOf(reported(accuracy), "nees_position")));
}

TEST(Accuracy, PercentilesLieBetweenTheValues) {
  EXPECT_NEAR(percentile({4.0, 1.0, 3.0, 2.0}, 50.0), 2.5, 1e-12);
  EXPECT_NEAR(percentile({4.0, 1.0, 3.0, 2.0}, 90.0), 3.7, 1e-12);
  EXPECT_NEAR(percentile({4.0, 1.0, 3.0, 2.0}, 100.0), 4.0, 1e-12);
  EXPECT_TRUE(std::isnan(percentile({}, 50.0)));
}

}  // namespace
}  // namespace track_evaluation
