#include "continuity.h"

#include <gtest/gtest.h>

#include <cmath>

#include "epoch_test_helpers.h"

namespace track_evaluation {
namespace {

// If one of these fails, a tracker that changes numbers or loses targets looks as good as one that does not.

/// One truth, of which at each epoch (one a second) a track with this number, or 0 for none, holds it.
MetricList ofOneTruth(const std::vector<std::uint32_t>& tracks, double initiation_limit = 2.0) {
  Continuity continuity(initiation_limit);
  double time = 0.0;
  for (const std::uint32_t id : tracks) {
    Epoch epoch;
    epoch.time = time++;
    epoch.truths = {truthAt(1, 0, 0)};
    if (id != 0) epoch.tracks = {trackAt(id, 0, 0)};
    continuity.add(epoch, {id == 0 ? -1 : 0}, {false}, true);
  }
  MetricList metrics;
  continuity.report(metrics);
  return metrics;
}

TEST(Continuity, ASwapIsAnotherTrackThanTheLastOne) {
  const MetricList metrics = ofOneTruth({5, 5, 6, 6, 5});
  EXPECT_EQ(valueOf(metrics, "swaps"), 2.0);
  EXPECT_EQ(valueOf(metrics, "breaks"), 0.0);
}

TEST(Continuity, ABreakIsLosingAndFindingAgain) {
  const MetricList metrics = ofOneTruth({5, 0, 0, 5, 0, 6});
  EXPECT_EQ(valueOf(metrics, "breaks"), 2.0);
  EXPECT_EQ(valueOf(metrics, "swaps"), 1.0);
  EXPECT_NEAR(valueOf(metrics, "mota"), 1.0 - (3.0 + 0.0 + 1.0) / 6.0, 1e-12);
}

TEST(Continuity, LosingForGoodIsNoBreak) { EXPECT_EQ(valueOf(ofOneTruth({5, 5, 0}), "breaks"), 0.0); }

TEST(Continuity, TheLongestSegmentIsTheLongestTimeWithOneTrack) {
  // Segments of 2, 3 and 1 epochs of 8.
  EXPECT_NEAR(valueOf(ofOneTruth({5, 5, 6, 6, 6, 0, 6, 0}), "longest_segment"), 3.0 / 8.0, 1e-12);
}

TEST(Continuity, SwapsForEachTruthHour) {
  // One swap of one truth in the 3 s between first and last epoch.
  EXPECT_NEAR(valueOf(ofOneTruth({5, 5, 6, 6}), "swaps_per_truth_hour"), 3600.0 / 3.0, 1e-9);
}

TEST(Continuity, TheInitiationDelayCountsFromTheFirstEpoch) {
  EXPECT_EQ(valueOf(ofOneTruth({0, 0, 5, 5}), "init_delay_med_s"), 2.0);
  EXPECT_EQ(valueOf(ofOneTruth({0, 0, 5, 5}, 2.0), "initiated_in_time"), 1.0);
  EXPECT_EQ(valueOf(ofOneTruth({0, 0, 5, 5}, 1.0), "initiated_in_time"), 0.0);
  // Too short a run to judge a limit of ten seconds.
  EXPECT_TRUE(std::isnan(valueOf(ofOneTruth({0, 0, 5, 5}, 10.0), "initiated_in_time")));
  EXPECT_EQ(valueOf(ofOneTruth({0, 0, 0}), "never_tracked"), 1.0);
}

TEST(Continuity, ATrackThatFollowsNobodyIsSpurious) {
  Continuity continuity(2.0);
  Epoch epoch;
  epoch.truths = {truthAt(1, 0, 0)};
  epoch.tracks = {trackAt(5, 0, 0), trackAt(6, 999, 0), trackAt(7, 888, 0)};
  continuity.add(epoch, {0}, {false, false, true}, true);  // 7 follows somebody who does not count.
  MetricList metrics;
  continuity.report(metrics);
  EXPECT_EQ(valueOf(metrics, "spurious_tracks"), 1.0);
  EXPECT_EQ(valueOf(metrics, "track_ids"), 3.0);
  EXPECT_NEAR(valueOf(metrics, "mota"), 0.0, 1e-12);
}

}  // namespace
}  // namespace track_evaluation
