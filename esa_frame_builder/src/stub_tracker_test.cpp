#include "stub_tracker.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dwell_test_helpers.h"

namespace esa_frame_builder {
namespace {

/// The tracker behind a window, fed frame by frame.
class StubTrackerTest : public testing::Test {
 protected:
  StubTrackerTest() : tracker_(params_, ArrayPose{}), window_(params_.window_frames) {}

  static Frame frameOf(std::vector<Dwell> dwells) {
    Frame frame;
    frame.dwells = std::move(dwells);
    return frame;
  }

  void close(std::vector<Dwell> dwells) {
    Frame frame = frameOf(std::move(dwells));
    frame.number = number_++;
    frame.closed = true;
    window_.shift(std::move(frame));
    tracker_.take(window_);
  }
  TrackReport report() { return tracker_.report(window_); }

  // One dwell that looks at u = v = 0, and what it sees at these ranges.
  static Dwell look(double time, const std::vector<double>& ranges) {
    Dwell dwell = dwellAt(time, 0.0, 0.0);
    for (double range : ranges) dwell.measurements.push_back(measurementAt(range, 0.0, 0.0));
    return dwell;
  }
  static Dwell lookElsewhere(double time) { return dwellAt(time, 0.3, 0.3); }

  const MfaStubParams params_;
  StubTracker tracker_;
  FrameWindow window_;
  std::uint32_t number_ = 0;
};

TEST_F(StubTrackerTest, BecomesFirmWithTheFourthMeasurementAndFollows) {
  for (int n = 0; n < 40; ++n) {
    close({look(0.1 * n, {50e3 - 25.0 * n})});  // 250 m/s inbound
    ASSERT_EQ(report().living.size(), 1U);
    EXPECT_EQ(report().living[0].stage, n < 3 ? TrackStage::kTentative : TrackStage::kFirm) << n;
  }
  const FrameTrack track = report().living[0];
  EXPECT_DOUBLE_EQ(track.time, 3.9);
  EXPECT_DOUBLE_EQ(track.first_detection, 0.0);
  EXPECT_NEAR(track.state.mean[0], 50e3 - 25.0 * 39, 10.0);
  EXPECT_NEAR(track.state.mean[3], -250.0, 10.0);
}

// Section 3's first problem of single dwells as frames: the window fills with frames from elsewhere.
TEST_F(StubTrackerTest, InitiationCountsFramesEvenThoseThatLookElsewhere) {
  close({look(0.0, {50e3})});
  close({look(0.1, {50e3})});
  for (int n = 2; n < params_.initiation_frames; ++n) close({lookElsewhere(0.1 * n)});
  const TrackReport last = report();
  EXPECT_TRUE(last.living.empty());
  ASSERT_EQ(last.updates.size(), 1U);
  EXPECT_TRUE(last.updates[0].dropped);
}

TEST_F(StubTrackerTest, ScoresTheThreeCases) {
  for (int n = 0; n < 5; ++n) close({look(0.1 * n, {50e3})});
  const double seen = report().living[0].score;
  EXPECT_GT(seen, 0.0);
  close({lookElsewhere(0.6)});
  EXPECT_TRUE(report().updates.empty()) << "out of view: nothing to say";
  EXPECT_EQ(report().living[0].score, seen);
  close({look(0.7, {})});
  TrackReport missed = report();
  ASSERT_EQ(missed.updates.size(), 1U);
  EXPECT_EQ(missed.updates[0].seen, FrameCase::kMissed);
  EXPECT_DOUBLE_EQ(missed.updates[0].track.time, 0.7) << "said where it should have been seen";
  // By hand: a mean SNR of 100 in the beam's centre, P_d = 1e-6^(1/101) = 0.872; a miss is ln(1 - P_d).
  EXPECT_NEAR(missed.living[0].score - seen, std::log(1.0 - 0.872), 0.03);
}

TEST_F(StubTrackerTest, IsDroppedOnceAfterMissesAndNeverAfterLooksElsewhere) {
  for (int n = 0; n < 5; ++n) close({look(0.1 * n, {50e3})});
  for (int n = 0; n < 50; ++n) close({lookElsewhere(1.0 + 0.1 * n)});
  EXPECT_EQ(report().living.size(), 1U);
  int drops = 0;
  for (int n = 0; n < 20; ++n) {
    close({look(6.1 + 0.01 * n, {})});
    for (const TrackUpdate& update : report().updates) drops += update.dropped ? 1 : 0;
  }
  EXPECT_EQ(drops, 1);
  EXPECT_TRUE(report().living.empty());
}

TEST_F(StubTrackerTest, IsDroppedWhenNotSeenForTooLong) {
  for (int n = 0; n < 5; ++n) close({look(0.1 * n, {50e3})});
  close({lookElsewhere(0.4 + params_.greatest_coast - 0.1)});
  EXPECT_EQ(report().living.size(), 1U);
  close({lookElsewhere(0.4 + params_.greatest_coast + 0.1)});
  EXPECT_TRUE(report().living.empty());
}

// By hand: tracks at 0 and 40 m, measurements at 10 and -30 m. The nearest pair, 10 m, would leave the second track
// without one; as a whole the first takes the one at -30 m and the second the one at 10 m.
TEST_F(StubTrackerTest, AssignsTheFrameAsAWhole) {
  for (int n = 0; n < 30; ++n) close({look(0.1 * n, {50e3, 50040.0})});
  ASSERT_EQ(report().living.size(), 2U);
  close({look(3.0, {50010.0, 49970.0})});
  const TrackReport after = report();
  ASSERT_EQ(after.living.size(), 2U) << "no new track";
  for (const FrameTrack& track : after.living) EXPECT_DOUBLE_EQ(track.time, 3.0);
  EXPECT_LT(after.living[0].state.mean[0], 50e3);
  EXPECT_LT(after.living[1].state.mean[0], 50040.0);
}

// Two targets 600 m apart across the beam whose ranges cross: for a while they are unresolved: one merged plot. If this
// fails, one track of a close pair is dropped whenever they draw level, and another one starts afterwards.
TEST_F(StubTrackerTest, CarriesTwoTracksThroughTheTimeInWhichTheyAreUnresolved) {
  const auto closeAt = [&](int n) {
    const double time = 0.1 * n, a = 50e3 + 150.0 - 10.0 * time, b = 50e3;
    const double u = 0.006;
    if (std::abs(a - b) < params_.range_resolution)
      close({dwellAt(time, 0.0, 0.0, {measurementAt(0.5 * (a + b), 0.0, 0.0, 200.0)})});
    else
      close({dwellAt(time, 0.0, 0.0, {measurementAt(a, u, 0.0), measurementAt(b, -u, 0.0)})});
  };
  for (int n = 0; n < 100; ++n) closeAt(n);
  ASSERT_EQ(report().living.size(), 2U);
  const std::uint32_t first = report().living[0].number, second = report().living[1].number;
  for (int n = 100; n < 300; ++n) closeAt(n);  // level between 12 and 18 s
  const TrackReport after = report();
  ASSERT_EQ(after.living.size(), 2U);
  EXPECT_EQ(after.living[0].number, first);
  EXPECT_EQ(after.living[1].number, second);
  EXPECT_NEAR(after.living[0].state.mean[1], -300.0, 30.0);
  EXPECT_NEAR(after.living[1].state.mean[1], 300.0, 30.0);
}

// If this fails, an early look at an open frame counts its measurements twice.
TEST_F(StubTrackerTest, AnEarlyLookShowsTheOpenFrameAndCommitsToNothing) {
  for (int n = 0; n < 5; ++n) close({look(0.1 * n, {50e3})});
  const TrackReport before = report();
  window_.look(frameOf({look(0.5, {50e3, 70e3})}));
  const TrackReport early = report();
  ASSERT_EQ(early.updates.size(), 1U) << "no track starts from an open frame";
  EXPECT_DOUBLE_EQ(early.living[0].time, 0.5);
  window_.clearOpen();
  EXPECT_DOUBLE_EQ(report().living[0].time, 0.4);
  EXPECT_EQ(report().living[0].score, before.living[0].score);
}

// At the very edge of the visible region the distance along boresight is not known: infinite covariance.
TEST_F(StubTrackerTest, LeavesOutAMeasurementAtTheEdgeOfTheVisibleRegion) {
  Dwell dwell = dwellAt(0.0, 0.0, 0.0, {measurementAt(50e3, 1.0, 0.0)});
  close({dwell});
  EXPECT_TRUE(report().living.empty());
}

}  // namespace
}  // namespace esa_frame_builder
