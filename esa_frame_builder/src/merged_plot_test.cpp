#include "merged_plot.h"

#include <gtest/gtest.h>

#include "dwell_test_helpers.h"

namespace esa_frame_builder {
namespace {

constexpr double kResolution = 30.0;  // [m]

/// Tracks before an array at the origin, and one dwell at u = v = 0 that sees them.
class MergedPlotTest : public testing::Test {
 protected:
  void add(double range, double u, double snr, TrackStage stage = TrackStage::kFirm) {
    FrameTrack track;
    track.stage = stage;
    track.snr = snr;
    track.state = tws::startState(spatialMeasurement(measurementAt(range, u, 0.0), pose_), 0.0);
    track.state.covariance.topLeftCorner<3, 3>() = Eigen::Matrix3d::Identity() * 400.0;
    all_.push_back(track);
  }

  MergedPlot mergedOf(std::size_t track) {
    Frame frame;
    frame.dwells = {dwellAt(0.0, 0.0, 0.0)};
    tracks_.clear();
    views_.clear();
    for (const FrameTrack& one : all_) {
      tracks_.push_back(&one);
      views_.push_back(viewOf(one, frame, pose_, MfaStubParams{}));
    }
    return mergedPlot(track, 0, tracks_, views_, kResolution);
  }

  const ArrayPose pose_{};
  std::vector<FrameTrack> all_;
  std::vector<const FrameTrack*> tracks_;
  std::vector<FrameView> views_;
};

// By hand: equal targets at u = ±0.004 and 50 km are 400 m apart and weigh the same: their centre is on boresight, and
// of their common covariance a half remains; the distance squared by twelve is added across.
TEST_F(MergedPlotTest, TwoEqualTargetsComeBackFromTheMiddle) {
  add(50e3, 0.004, 50.0);
  add(50e3, -0.004, 50.0);
  const MergedPlot merged = mergedOf(0);
  EXPECT_EQ(merged.members, (std::vector<std::size_t>{0, 1}));
  EXPECT_NEAR(merged.place.y(), 0.0, 1e-6);
  EXPECT_NEAR(merged.covariance(0, 0), 200.0, 1e-3);
  EXPECT_NEAR(merged.covariance(1, 1), 200.0 + 400.0 * 400.0 / 12.0, 1e-3);
  EXPECT_EQ(mergedOf(1).members, merged.members);
}

TEST_F(MergedPlotTest, TheStrongerTargetPullsTheMergedPlotTowardsItself) {
  add(50e3, 0.004, 75.0);
  add(50e3, -0.004, 25.0);
  EXPECT_NEAR(mergedOf(0).place.y(), -100.0, 1e-6) << "y is to the left";
}

// If this fails, resolved tracks are pulled away from their plots, or false ones live on in the shadow of others.
TEST_F(MergedPlotTest, OnlyFirmTracksOfOneRangeAndOneBeamMerge) {
  add(50e3, 0.004, 50.0);
  add(50e3 + 40.0, -0.004, 50.0);  // range parts them
  add(50e3, 0.06, 50.0);           // outside the beam
  add(50e3, 0.0, 50.0, TrackStage::kTentative);
  EXPECT_TRUE(mergedOf(0).members.empty());
  EXPECT_TRUE(mergedOf(3).members.empty());
}

// By hand: the merged plot lies 30 m further and 60 m to the left of the predicted centre, and so does each member.
TEST_F(MergedPlotTest, EachMemberMovesAsTheMergedPlotDoes) {
  add(50e3, 0.004, 50.0);
  add(50e3, -0.004, 50.0);
  const MergedPlot merged = mergedOf(0);
  const tws::SpatialMeasurement measured{merged.place + Eigen::Vector3d(30.0, 60.0, 0.0),
                                         Eigen::Matrix3d::Identity() * 9.0};
  const tws::SpatialMeasurement share = memberMeasurement(merged, measured, all_[1].state);
  EXPECT_NEAR((share.position - all_[1].state.mean.head<3>() - Eigen::Vector3d(30.0, 60.0, 0.0)).norm(), 0.0, 1e-9);
  EXPECT_NEAR(share.covariance(0, 0), 209.0, 1e-3);
}

}  // namespace
}  // namespace esa_frame_builder
