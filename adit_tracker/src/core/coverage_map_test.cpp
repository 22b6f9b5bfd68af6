#include "core/coverage_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>

namespace adit_tracker {
namespace {

class CoverageMapTest : public testing::Test {
 protected:
  double anyAzimuth() { return tws::uniform(generator_, 0.0, tws::kTwoPi); }

  /// A target that is met every 2 km up to `to`, and seen up to `seen`.
  void flyOut(double azimuth, double seen, double to) {
    for (double range = 20e3; range < to; range += 2e3) {
      if (range < seen) map_.addPlot(range, azimuth, 0.0);
      map_.look(range, azimuth, range < seen ? 1.0 : 0.0, 1.0);
    }
  }

  std::mt19937_64 generator_ = tws::seededGenerator();
  CoverageMap map_;
};

// If this fails, the first tracks end where the radar has not shown yet that it sees them.
TEST_F(CoverageMapTest, AtFirstNothingIsBlind) {
  EXPECT_FALSE(map_.hasLooked());
  for (const double range : {1e3, 50e3, 500e3}) EXPECT_FALSE(map_.isBlind(range, 1.0));
}

// If this fails, aircraft that have left are shown on and on.
TEST_F(CoverageMapTest, TracksThatLeaveTeachTheGreatestRangeForAllAzimuths) {
  for (int i = 0; i < 15; ++i) flyOut(anyAzimuth(), 100e3, 106e3);
  for (double azimuth = 0.05; azimuth < tws::kTwoPi; azimuth += 0.1) {
    EXPECT_FALSE(map_.isBlind(95e3, azimuth)) << azimuth;
    EXPECT_TRUE(map_.isBlind(104e3, azimuth)) << azimuth;
    EXPECT_TRUE(map_.isBlind(150e3, azimuth)) << azimuth;
  }
}

// If this fails, a mast that hides a sector ends the tracks behind it, or a blind sector makes all others blind.
TEST_F(CoverageMapTest, ABlindSectorIsLearnedAsOne) {
  const double blind = 10.5 * tws::kSectorWidth;
  for (int i = 0; i < 60; ++i) {
    flyOut(anyAzimuth(), 200e3, 100e3);
    if (i % 4 == 0) flyOut(blind, 0.0, 100e3);
    if (i % 10 == 0) flyOut(8.5 * tws::kSectorWidth, 200e3, 100e3);
  }
  EXPECT_TRUE(map_.isBlind(60e3, blind));
  EXPECT_FALSE(map_.isBlind(60e3, 8.5 * tws::kSectorWidth));
  EXPECT_FALSE(map_.isBlind(60e3, 40.5 * tws::kSectorWidth));
}

// If this fails, a radar that is switched off for some scans is taken for blind when it is back.
TEST_F(CoverageMapTest, ARadarThatIsOffTeachesLittle) {
  for (int i = 0; i < 60; ++i) flyOut(anyAzimuth(), 200e3, 100e3);
  for (int i = 0; i < 300; ++i) map_.look(tws::uniform(generator_, 20e3, 100e3), anyAzimuth(), 0.0, 1.0);
  int blind = 0;
  for (int i = 0; i < 1000; ++i) blind += map_.isBlind(tws::uniform(generator_, 20e3, 95e3), anyAzimuth());
  EXPECT_LT(blind, 20);
}

// If this fails, what was hidden once stays hidden.
TEST_F(CoverageMapTest, WhatIsSeenAgainIsCovered) {
  const double azimuth = 10.5 * tws::kSectorWidth;
  for (int i = 0; i < 60; ++i) flyOut(anyAzimuth(), 200e3, 100e3);
  for (int i = 0; i < 40; ++i) map_.look(60e3, azimuth, 0.0, 1.0);
  ASSERT_TRUE(map_.isBlind(60e3, azimuth));
  for (int i = 0; i < 20; ++i) map_.look(60e3, azimuth, 1.0, 1.0);
  EXPECT_FALSE(map_.isBlind(60e3, azimuth));
}

// 20 a scan, evenly over the disk, show in ten scans that nothing comes from 103 km.
TEST_F(CoverageMapTest, FalsePlotsShowTheGreatestRangeBeforeAnyTrackDoes) {
  for (int i = 0; i < 200; ++i) map_.addPlot(100e3 * std::sqrt(tws::uniform(generator_, 0.0, 1.0)), anyAzimuth(), 1.0);
  EXPECT_TRUE(map_.isBlind(103e3, 1.0));
  EXPECT_FALSE(map_.isBlind(99e3, 1.0));
}

// The first aircraft to fly out of clutter that lies all around. If this fails, it ends at its first miss.
TEST_F(CoverageMapTest, WhereTargetsComeFromFartherThanFalsePlotsThatShowsNothing) {
  for (int i = 0; i < 2000; ++i) map_.addPlot(90e3 * std::sqrt(tws::uniform(generator_, 0.0, 1.0)), anyAzimuth(), 1.0);
  for (double range = 91.0e3; range < 120e3; range += 500.0) {
    map_.addPlot(range, 2.0, 1e-4);
    EXPECT_FALSE(map_.isBlind(range + 1e3, 2.0)) << range;
  }
}

// If this fails, what flies on beyond a shower ends there.
TEST_F(CoverageMapTest, AShowerOnOneSideShowsNothing) {
  for (int i = 0; i < 2000; ++i)
    map_.addPlot(tws::uniform(generator_, 60e3, 90e3), tws::uniform(generator_, 1.0, 1.7), 1.0);
  EXPECT_FALSE(map_.isBlind(92e3, 1.3));
  EXPECT_FALSE(map_.isBlind(92e3, 4.0));
}

// If this fails, one plot of a radar's fault makes all that was learned of it too coarse to be of use.
TEST_F(CoverageMapTest, OneMadRangeChangesNothing) {
  map_.addPlot(5e6, 1.0, 1.0);
  for (int i = 0; i < 15; ++i) flyOut(anyAzimuth(), 100e3, 106e3);
  EXPECT_FALSE(map_.isBlind(95e3, 1.0));
  EXPECT_TRUE(map_.isBlind(104e3, 1.0));
}

// One target was lost there, and its track coasts on. If this fails, the radar counts as blind far around, and ends
// the tracks there.
TEST_F(CoverageMapTest, OneLostTrackBlindsNoMoreThanItsOwnSector) {
  const double lost = 20.5 * tws::kSectorWidth;
  flyOut(5.5 * tws::kSectorWidth, 200e3, 60e3);
  for (int i = 0; i < 20; ++i) map_.look(80e3, lost, 0.0, 1.0);
  EXPECT_TRUE(map_.isBlind(80e3, lost));
  for (int sector = 0; sector < tws::kSectors; ++sector) {
    if (sector == 20) continue;
    EXPECT_FALSE(map_.isBlind(80e3, (sector + 0.5) * tws::kSectorWidth)) << sector;
  }
}

TEST_F(CoverageMapTest, FiveMissesOfOneTrackBlindNothing) {
  for (int i = 0; i < 5; ++i) map_.look(80e3, 2.0, 0.0, 1.0);
  for (double azimuth = 0.05; azimuth < tws::kTwoPi; azimuth += 0.1) EXPECT_FALSE(map_.isBlind(80e3, azimuth));
}

// If this fails, each run learns anew where the radar sees nothing.
TEST_F(CoverageMapTest, WhatWasSavedIsKnownAndGivesWay) {
  const double blind = 10.5 * tws::kSectorWidth;
  for (int i = 0; i < 60; ++i) {
    flyOut(anyAzimuth(), 100e3, 106e3);
    if (i % 2 == 0) flyOut(blind, 0.0, 100e3);
  }
  RadarCounts counts;
  map_.save(counts);
  EXPECT_EQ(problemOf(counts), "");
  CoverageMap next;
  next.load(counts);
  EXPECT_TRUE(next.hasLooked());
  EXPECT_TRUE(next.isBlind(60e3, blind));
  EXPECT_TRUE(next.isBlind(104e3, 3.0));
  EXPECT_FALSE(next.isBlind(60e3, 40.5 * tws::kSectorWidth));
  next.load(counts);  // once more
  for (int i = 0; i < 3; ++i) next.look(60e3, blind, 1.0, 1.0);
  EXPECT_FALSE(next.isBlind(60e3, blind));
}

TEST_F(CoverageMapTest, IsLoadedIntoBinsOfAnotherDepth) {
  for (int i = 0; i < 60; ++i) flyOut(anyAzimuth(), 100e3, 106e3);
  RadarCounts counts;
  map_.save(counts);
  CoverageMap far;
  for (int i = 0; i < 3; ++i) far.addPlot(300e3, 1.0, 0.0);
  far.load(counts);
  EXPECT_FALSE(far.isBlind(80e3, 3.0));
  far.save(counts);
  CoverageMap next;
  next.load(counts);
  EXPECT_FALSE(next.isBlind(80e3, 3.0));
}

}  // namespace
}  // namespace adit_tracker
