#include "frame_view.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/random_test_helpers.h>
#include <tws_core/sine_space.h>

#include "dwell_test_helpers.h"

namespace esa_frame_builder {
namespace {

/// An array 100 m up that looks north, tilted back by 20 degrees.
ArrayPose tiltedPose() { return {{1000.0, -500.0, 100.0}, tws::enuFromArrayRotation(0.0, 0.35)}; }

TEST(ArrayPose, PlacesAMeasurementWithTheSpreadOfSimulatedOnes) {
  auto generator = tws::seededGenerator();
  const ArrayPose pose = tiltedPose();
  Measurement truth = measurementAt(60e3, 0.3, -0.2);
  truth.covariance << 100.0, 0.0, 0.0, 0.0, 1e-6, 5e-7, 0.0, 5e-7, 2e-6;
  const tws::SpatialMeasurement placed = spatialMeasurement(truth, pose);
  const Eigen::Matrix3d root = truth.covariance.llt().matrixL();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  constexpr int kCount = 100000;
  for (int i = 0; i < kCount; ++i) {
    std::normal_distribution<double> normal;
    const Eigen::Vector3d e = root * Eigen::Vector3d(normal(generator), normal(generator), normal(generator));
    const Eigen::Vector3d place =
        pose.place + pose.axes * tws::arrayFromRuv({truth.range + e[0], truth.u + e[1], truth.v + e[2]});
    mean += (place - placed.position) / kCount;
    spread += (place - placed.position) * (place - placed.position).transpose() / kCount;
  }
  EXPECT_LT(mean.norm(), 1.0);
  // A sample variance of n has the relative deviation √(2/n) = 0.45 %; five of them.
  EXPECT_LT((spread - placed.covariance).norm(), 0.023 * placed.covariance.norm());
}

TEST(ArrayPose, ViewsAStateWhereItsMeasurementWas) {
  const ArrayPose pose = tiltedPose();
  const tws::SpatialState state = tws::startState(spatialMeasurement(measurementAt(60e3, 0.3, -0.2), pose), 100.0);
  const ArrayView view = arrayView(state, pose);
  EXPECT_TRUE(view.is_ahead);
  EXPECT_NEAR(view.range, 60e3, 1e-6);
  EXPECT_NEAR(view.u, 0.3, 1e-12);
  EXPECT_NEAR(view.v, -0.2, 1e-12);
  EXPECT_NEAR(view.covariance(0, 0), 0.25e-6, 1e-11);
  EXPECT_NEAR(view.covariance(1, 1), 0.25e-6, 1e-11);
  tws::SpatialState behind = state;
  behind.mean.head<3>() = 2.0 * pose.place - state.mean.head<3>();
  EXPECT_FALSE(arrayView(behind, pose).is_ahead);
}

// At the half-power width the one-way power is a half, so the two-way power a quarter; two widths' worth off, (1/4)^4.
TEST(FrameView, BeamLossFallsToAQuarterAtTheHalfPowerEdge) {
  const Dwell dwell = dwellAt(0.0, 0.1, 0.0);
  const Eigen::Matrix2d sure = Eigen::Matrix2d::Zero();
  EXPECT_DOUBLE_EQ(beamLoss(dwell, {true, 1.0, 0.1, 0.0, sure}), 1.0);
  EXPECT_NEAR(beamLoss(dwell, {true, 1.0, 0.11, 0.0, sure}), 0.25, 1e-12);
  EXPECT_NEAR(beamLoss(dwell, {true, 1.0, 0.1, 0.02, sure}), 1.0 / 256.0, 1e-12);
}

TEST(FrameView, BeamLossIsTheMeanOverAnUncertainDirection) {
  auto generator = tws::seededGenerator();
  const Dwell dwell = dwellAt(0.0, 0.0, 0.0);
  Eigen::Matrix2d covariance;
  covariance << 4e-5, 1e-5, 1e-5, 2e-5;
  const Eigen::Matrix2d root = covariance.llt().matrixL();
  double mean = 0.0;
  constexpr int kCount = 200000;
  for (int i = 0; i < kCount; ++i) {
    std::normal_distribution<double> normal;
    const Eigen::Vector2d e = root * Eigen::Vector2d(normal(generator), normal(generator));
    mean += beamLoss(dwell, {true, 1.0, 0.005 + e[0], -0.004 + e[1], Eigen::Matrix2d::Zero()}) / kCount;
  }
  EXPECT_NEAR(beamLoss(dwell, {true, 1.0, 0.005, -0.004, covariance}), mean, 0.005);
}

// By hand: 1e-6^(1/20) = 10^-0.3 = 0.501.
TEST(FrameView, DetectionProbabilityIsSwerlings) {
  EXPECT_NEAR(detectionProbability(19.0, 1e-6), 0.5012, 1e-4);
  EXPECT_DOUBLE_EQ(detectionProbability(0.0, 1e-6), 1e-6);
}

FrameTrack trackAt(const Measurement& measurement, const ArrayPose& pose) {
  FrameTrack track;
  track.time = 10.0;
  track.state = tws::startState(spatialMeasurement(measurement, pose), 1.0);
  track.snr = 99.0;
  return track;
}

// The paper's cases: in the beam of one dwell it should be seen, of two more surely, elsewhere not at all.
TEST(FrameView, ATrackShouldBeSeenWhereABeamLooksAndNowhereElse) {
  const ArrayPose pose = tiltedPose();
  const MfaStubParams params;
  const FrameTrack track = trackAt(measurementAt(60e3, 0.3, -0.2), pose);
  const auto chance = [&](const std::vector<Dwell>& dwells) {
    Frame frame;
    frame.dwells = dwells;
    return viewOf(track, frame, pose, params).detection_probability;
  };
  const Dwell on = dwellAt(10.1, 0.3, -0.2), off = dwellAt(10.1, 0.4, -0.2), before = dwellAt(9.9, 0.3, -0.2);
  Dwell shorter = on;
  shorter.range_max = 59e3;
  const double once = chance({on});
  EXPECT_NEAR(once, detectionProbability(99.0, params.false_alarm_probability), 0.01);
  EXPECT_NEAR(chance({on, on}), 1.0 - (1.0 - once) * (1.0 - once), 1e-12);
  EXPECT_LT(chance({off}), 1e-3);
  EXPECT_EQ(chance({before}), 0.0) << "already taken";
  EXPECT_EQ(chance({shorter}), 0.0) << "out of the receive window";
  EXPECT_EQ(chance({}), 0.0);
}

}  // namespace
}  // namespace esa_frame_builder
