#include "core/cluster_weigher.h"

#include <gtest/gtest.h>

namespace adit_tracker {
namespace {

constexpr double kFalse = 1e-9;  // density of false plots [1/m²]

/// Tracks of chance 1 - 1e-5, detected with 0.9 unless a test says so, and detections; who may have made which.
class ClusterWeigherTest : public testing::Test {
 protected:
  ClusterWeigherTest() { detections_.resize(4); }

  TrackFile::Slot track(double existence = 0.99999, double detected = 0.9, bool primary = true) {
    const auto slot = *tracks_.start();
    tracks_.at(slot).existence = static_cast<float>(existence);
    tracks_.at(slot).detection_probability.fill(static_cast<float>(detected));
    entries_.push_back({slot, entries_.size(), primary, false, candidates_.size(), candidates_.size()});
    return slot;
  }
  /// Of the latest track: the detection fits it `ratio` times as well as it fits a false plot.
  void candidate(std::size_t detection, double ratio) {
    detections_[detection].false_density = kFalse;
    candidates_.push_back({&detections_[detection], 0.0, 0, ratio * kFalse});
    entries_.back().last = candidates_.size();
  }
  void weigh(double merged = 0.0) {
    weigher_.weigh(tracks_, entries_, candidates_, {400.0, 0.03, merged}, 7, correlations_);
  }
  double chanceOf(const Correlation& c, std::size_t i) const { return weigher_.chances()[c.first + i].chance; }

  TrackFile tracks_{100};
  std::vector<Detection> detections_;
  std::vector<Entry> entries_;
  std::vector<Candidate> candidates_;
  std::vector<Correlation> correlations_;
  ClusterWeigher weigher_;
};

// If this fails, whoever has an empty sky pays for weighing, and gets other tracks.
TEST_F(ClusterWeigherTest, ATrackAloneWithItsOnlyDetectionTakesIt) {
  const auto slot = track();
  candidate(0, 1000.0);
  weigh();
  ASSERT_EQ(correlations_.size(), 1U);
  EXPECT_FALSE(correlations_[0].weighed);
  EXPECT_EQ(correlations_[0].detection, detections_.data());
  EXPECT_TRUE(detections_[0].used);
  EXPECT_EQ(detections_[0].taker, slot);
}

// Odds 0.9 · 0.5 / 0.1 = 4.5 against a miss: 0.818 it is. If this fails, a far false plot drags a track away.
TEST_F(ClusterWeigherTest, ADoubtfulDetectionIsWeighedAgainstAMiss) {
  track();
  candidate(0, 0.5);
  weigh();
  ASSERT_TRUE(correlations_[0].weighed);
  EXPECT_NEAR(chanceOf(correlations_[0], 0), 4.5 / 5.5, 1e-3);
  EXPECT_NEAR(correlations_[0].missed, 1.0 / 5.5, 1e-3);
  EXPECT_NEAR(detections_[0].left, 1.0 / 5.5, 1e-3);
  EXPECT_FALSE(detections_[0].used);
}

// Half a chance to exist: seen 0.45, odds 0.45 · 20 / 0.55 = 16.36 for each of two plots; missed though there 0.05 /
// 0.55. Existence (32.73 + 0.0909) / 33.73.
TEST_F(ClusterWeigherTest, ExistenceComesFromAllThatMayHaveHappened) {
  track(0.5);
  candidate(0, 20.0);
  candidate(1, 20.0);
  weigh();
  const double odds = 0.45 * 20.0 / 0.55, there = 0.05 / 0.55;
  EXPECT_NEAR(correlations_[0].existence, (2.0 * odds + there) / (1.0 + 2.0 * odds), 1e-4);
  EXPECT_EQ(correlations_[0].detection, nullptr);  // neither is rather its own than not
}

// If this fails, a tentative track near a firm one takes its detections.
TEST_F(ClusterWeigherTest, OfTwoTracksTheLikelierTargetGetsTheDetection) {
  const auto firm = track();
  candidate(0, 100.0);
  track(0.01);
  candidate(0, 100.0);
  weigh();
  ASSERT_EQ(correlations_.size(), 2U);
  EXPECT_EQ(correlations_[0].detection, detections_.data());
  EXPECT_EQ(correlations_[1].detection, nullptr);
  EXPECT_EQ(correlations_[0].cluster, correlations_[1].cluster);
  EXPECT_EQ(detections_[0].taker, firm);
  EXPECT_LT(correlations_[1].existence, 0.01);
}

// If this fails, a track takes what the one in the next sector needs.
TEST_F(ClusterWeigherTest, ASecondaryTrackCompetesAndIsNotUpdated) {
  track();
  candidate(0, 10.0);
  track(0.99999, 0.9, false);
  candidate(0, 1000.0);
  weigh();
  ASSERT_EQ(correlations_.size(), 1U);
  EXPECT_GT(correlations_[0].missed, 0.9);
  EXPECT_EQ(detections_[0].flagged_in, 7U);
  EXPECT_FALSE(detections_[0].used);
}

// Odds of the first track 90, of the second 9000: 9000 / 9091 is its chance, asked at once or after the first one. If
// this fails, who is asked later gets less, or more, than is its due.
TEST_F(ClusterWeigherTest, WhatIsLeftToALaterTrackIsWhatBothTogetherWouldLeaveIt) {
  track();
  candidate(0, 10.0);
  track(0.99999, 0.9, false);
  candidate(0, 1000.0);
  weigh();
  entries_.clear();
  candidates_.clear();
  correlations_.clear();
  detections_[0].askers = 0;
  detections_[0].index = Detection::kNoIndex;
  track();
  candidate(0, 1000.0);
  weigh();
  ASSERT_TRUE(correlations_[0].weighed);
  EXPECT_NEAR(chanceOf(correlations_[0], 0), 9000.0 / 9091.0, 1e-3);
}

/// Two firm tracks at one place want the only plot.
class MergedPlotTest : public ClusterWeigherTest {
 protected:
  MergedPlotTest() {
    for (int i = 0; i < 2; ++i) {
      tracks_.at(track(0.9)).firm = true;
      candidate(0, 1000.0);
    }
  }
};

// If this fails, nobody takes what a radar makes of two aircraft in one cell, and bifurcation has nothing to share.
TEST_F(MergedPlotTest, IsTakenByOneOfTwoEqualTracks) {
  weigh();
  ASSERT_EQ(correlations_.size(), 2U);
  EXPECT_EQ(correlations_[0].detection, detections_.data());
  EXPECT_EQ(correlations_[1].detection, nullptr);
  EXPECT_EQ(detections_[0].taker, correlations_[0].slot);
}

// If this fails, aircraft that fly together lose their tracks within some scans.
TEST_F(MergedPlotTest, IsNoEvidenceAgainstTheOtherWhereTheRadarMerges) {
  weigh();
  EXPECT_LT(correlations_[1].existence, 0.75);
  entries_[0].correlated = entries_[1].correlated = false;
  correlations_.clear();
  detections_[0] = Detection{};
  detections_[0].false_density = kFalse;
  weigh(0.9);
  EXPECT_GT(correlations_[1].existence, 0.8);
}

TEST_F(ClusterWeigherTest, TracksWithoutACommonDetectionFormClustersOfTheirOwn) {
  track();
  candidate(0, 10.0);
  candidate(1, 10.0);
  track();
  candidate(2, 10.0);
  candidate(3, 10.0);
  weigh();
  ASSERT_EQ(correlations_.size(), 2U);
  EXPECT_NE(correlations_[0].cluster, correlations_[1].cluster);
}

// If this fails, two tracks of sectors side by side are both updated by one detection.
TEST_F(ClusterWeigherTest, WhatEarlierTracksHaveTakenIsNotThereAgain) {
  track();
  candidate(0, 100.0);
  detections_[0].left = 0.001;
  weigh();
  EXPECT_GT(correlations_[0].missed, 0.5);
}

}  // namespace
}  // namespace adit_tracker
