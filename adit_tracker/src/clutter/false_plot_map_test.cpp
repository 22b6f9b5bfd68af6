#include "clutter/false_plot_map.h"

#include <gtest/gtest.h>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>
#include <cmath>

namespace adit_tracker {
namespace {

constexpr double kDisk = tws::kPi * 1e10;  // of 100 km [m²]
constexpr double kPatch = 0.5 * (50e3 * 50e3 - 20e3 * 20e3) * 4.0 * tws::kSectorWidth;

/// Scans of a radar that sees to 100 km: false plots all over the disk, and more in a patch of four sectors from 20 to
/// 50 km.
class FalsePlotMapTest : public testing::Test {
 protected:
  FalsePlotMapTest() { map_.addRange(100e3); }

  void scan(int times, double in_disk, double in_patch) {
    std::uniform_real_distribution<double> chance(0.0, 1.0);
    for (int i = 0; i < 64 * times; ++i) {
      const int sector = i % 64;
      const bool patch = sector >= 8 && sector < 12;
      for (int n = count(in_disk / 64.0); n > 0; --n) map_.add(sector, 100e3 * std::sqrt(chance(generator_)), 1.0);
      for (int n = patch ? count(in_patch / 4.0) : 0; n > 0; --n)
        map_.add(sector, std::sqrt(4e8 + 21e8 * chance(generator_)), 1.0);
      map_.close(sector);
    }
  }
  int count(double mean) { return std::poisson_distribution<int>(mean)(generator_); }
  double at(double range, int sector) const { return map_.density(range, (sector + 0.5) * tws::kSectorWidth); }
  double inPatch() const { return (at(30e3, 9) + at(35e3, 10) + at(40e3, 9) + at(45e3, 10)) / 4.0; }

  std::mt19937_64 generator_ = tws::seededGenerator();
  FalsePlotMap map_;
};

// If this fails, the chance of existence weighs plots by a wrong density of false ones.
TEST_F(FalsePlotMapTest, LearnsHowManyFalsePlotsThereAre) {
  scan(40, 50.0, 0.0);
  EXPECT_NEAR(map_.perScan(), 50.0, 10.0);
  double sum = 0.0;
  for (int sector = 0; sector < 64; ++sector) sum += (at(70e3, sector) + at(90e3, sector)) / 128.0;
  EXPECT_NEAR(sum * kDisk, 50.0, 25.0);
}

TEST_F(FalsePlotMapTest, ExpectsAFewBeforeItHasSeenAny) {
  EXPECT_NEAR(map_.perScan(), 5.0, 1e-9);
  EXPECT_NEAR(at(50e3, 7) * kDisk, 5.0, 1e-9);
  scan(100, 0.0, 0.0);
  EXPECT_LT(map_.perScan(), 1.0);
  EXPECT_GT(at(50e3, 7), 0.0);
}

// If this fails, a patch of rain fills with tracks, or the sky round it is blind.
TEST_F(FalsePlotMapTest, FindsAPatchWithinTenScansAndLeavesTheRestAlone) {
  scan(10, 20.0, 100.0);
  EXPECT_NEAR(inPatch() * kPatch, 100.0, 40.0);
  EXPECT_LT(at(35e3, 40) * kDisk, 60.0);
  EXPECT_LT(at(90e3, 9) * kDisk, 120.0);  // in the same sectors, further out
}

// If this fails, rain that has gone hides aircraft for long.
TEST_F(FalsePlotMapTest, ForgetsAPatchThatHasGone) {
  scan(20, 20.0, 100.0);
  const double then = inPatch();
  scan(24, 20.0, 0.0);
  EXPECT_LT(inPatch(), 0.12 * then);
}

// One plot against a prior of two plots in each of the cells that hold it.
TEST_F(FalsePlotMapTest, IsHardlyChangedByASinglePlot) {
  scan(20, 20.0, 0.0);
  const double before = at(60e3, 30);
  map_.add(30, 60e3, 1.0);
  for (int sector = 0; sector < 64; ++sector) map_.close(sector);
  EXPECT_GT(at(60e3, 30), before);
  EXPECT_LT(at(60e3, 30), 4.0 * before);
}

// If this fails, an aircraft's own first plots say that its place is cluttered, and it gets its track late; or none of
// them counts, and clutter fills with tracks.
TEST_F(FalsePlotMapTest, CountsATracksOwnPlotsInTheSmallestCellOnly) {
  scan(20, 20.0, 100.0);
  const double azimuth = 30.5 * tws::kSectorWidth, before = map_.density(60e3, azimuth), patch = inPatch();
  map_.add(30, 60e3, 1.0);
  map_.close(30);
  const double with = map_.density(60e3, azimuth), around = map_.densityAround(FalsePlotMap::kKept, 60e3, azimuth);
  EXPECT_GT(around, 1.2 * before);
  EXPECT_LT(around, 1.6 * before);
  EXPECT_GT(with, 1.3 * around);
  EXPECT_DOUBLE_EQ(map_.densityAround(0.0, 60e3, azimuth), with);
  const double there = map_.density(35e3, 9.5 * tws::kSectorWidth);
  EXPECT_GT(there, 0.2 * patch);
  EXPECT_DOUBLE_EQ(map_.densityAround(1.0, 35e3, 9.5 * tws::kSectorWidth), there);  // one of many
}

// If this fails, a plot that is surely an aircraft's counts as clutter.
TEST_F(FalsePlotMapTest, CountsAPlotByItsChanceToBeFalse) {
  for (int i = 0; i < 64 * 40; ++i) {
    map_.add(i % 64, 50e3, 0.25);
    map_.close(i % 64);
  }
  EXPECT_NEAR(map_.perScan(), 16.0, 1.0);
}

// If this fails, the first far plot makes the map forget the near ones.
TEST_F(FalsePlotMapTest, KeepsWhatItKnowsWhenARadarSeesFarther) {
  scan(20, 20.0, 100.0);
  const double then = inPatch();
  map_.addRange(500e3);
  EXPECT_DOUBLE_EQ(map_.greatestRange(), 500e3);
  for (int sector = 0; sector < 64; ++sector) map_.close(sector);
  EXPECT_GT(inPatch(), 0.3 * then);
}

// If this fails, a tracker begins each day with the tracks that yesterday's rain and land have started.
TEST_F(FalsePlotMapTest, WhatWasSavedIsThereFromTheFirstScan) {
  scan(20, 20.0, 100.0);
  RadarCounts counts;
  map_.save(counts);
  FalsePlotMap next;
  next.load(counts);
  EXPECT_EQ(problemOf(counts), "");
  EXPECT_DOUBLE_EQ(next.greatestRange(), map_.greatestRange());
  EXPECT_NEAR(next.perScan(), map_.perScan(), 0.4 * map_.perScan());  // the first guess weighs half a scan
  const double then = inPatch();
  map_ = next;
  EXPECT_NEAR(inPatch(), then, 0.3 * then);
  EXPECT_LT(at(35e3, 40) * kDisk, 60.0);
}

// If this fails, yesterday's map holds against what is seen today.
TEST_F(FalsePlotMapTest, WhatWasSavedGivesWayInAFewScans) {
  scan(20, 20.0, 100.0);
  RadarCounts counts;
  map_.save(counts);
  const double then = inPatch();
  map_ = FalsePlotMap();
  map_.load(counts);
  scan(8, 20.0, 0.0);
  EXPECT_LT(inPatch(), 0.15 * then);
}

TEST_F(FalsePlotMapTest, OneScanOfItsOwnIsBetterThanWhatWasSaved) {
  scan(20, 20.0, 100.0);
  RadarCounts counts;
  map_.save(counts);
  map_ = FalsePlotMap();
  map_.addRange(100e3);
  scan(2, 20.0, 0.0);
  const double seen = inPatch();
  map_.load(counts);
  EXPECT_DOUBLE_EQ(inPatch(), seen);
}

// If this fails, a map saved by a radar that has once seen farther stands at wrong ranges, or the other way round.
TEST_F(FalsePlotMapTest, IsLoadedIntoBinsOfAnotherDepth) {
  scan(20, 20.0, 100.0);
  const double then = inPatch();
  RadarCounts fine, coarse;
  map_.save(fine);
  map_.addRange(190e3);
  map_.save(coarse);
  EXPECT_GT(coarse.false_plots.depth, fine.false_plots.depth);
  FalsePlotMap far, near;
  far.addRange(300e3);
  far.load(fine);
  near.load(coarse);
  for (const FalsePlotMap& map : {far, near}) {
    map_ = map;
    EXPECT_GT(inPatch(), 0.3 * then);
    EXPECT_LT(at(70e3, 9), 0.5 * inPatch());
  }
}

// If this fails, a map of hostile numbers stops the tracker or spreads numbers that are none.
TEST_F(FalsePlotMapTest, TheExtremesOfWhatIsAllowedDoNoHarm) {
  for (const CellCount cell : {CellCount{1e5F, 1e-30F}, CellCount{0.0F, 100.0F}, CellCount{1e5F, 0.0F}}) {
    RadarCounts counts;
    counts.greatest_range = 1e7;
    counts.false_plots.depth = 160e3;
    counts.false_plots.cells.assign(CellCounts::kCells, cell);
    ASSERT_EQ(problemOf(counts), "");
    map_ = FalsePlotMap();
    map_.load(counts);
    scan(1, 20.0, 0.0);
    EXPECT_TRUE(std::isfinite(map_.perScan()) && map_.perScan() >= 0.0);
    for (const double range : {0.0, 50e3, 9e6}) EXPECT_TRUE(std::isfinite(at(range, 9)) && at(range, 9) > 0.0) << range;
  }
}

}  // namespace
}  // namespace adit_tracker
