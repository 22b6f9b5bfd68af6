#include "io/snapshot_feed.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>
#include <tws_core/units.h>

#include "core/plot_test_helpers.h"

namespace adit_tracker {
namespace {

/// Targets all round that hardly move, each 6 s.
std::vector<tws::Plot> snapshots(int scans) {
  std::vector<tws::Plot> plots;
  for (int scan = 0; scan < scans; ++scan)
    for (int target = 0; target < 8; ++target)
      plots.push_back(plotAt(6.0 * (scan + 1), 30e3, tws::radians(45.0 * target + 0.5 * scan)));
  return plots;
}

/// The same from a beam that turns in `turn` seconds, whose times are whole steps.
std::vector<tws::Plot> turning(double turn, double step) {
  std::vector<tws::Plot> plots;
  for (double time = 0.0; time < 20 * turn; time += turn / 40.0)
    plots.push_back(plotAt(step * std::floor(time / step), 30e3, tws::kTwoPi * time / turn));
  return plots;
}

// If it fails, files that most other trackers write and read give no tracks, or wrong ones.
TEST(SnapshotFeed, KnowsSnapshotsFromABeamThatTurns) {
  ASSERT_TRUE(snapshotPeriod(snapshots(10)));
  EXPECT_NEAR(*snapshotPeriod(snapshots(10)), 6.0, 1e-9);
  for (const auto& [turn, step] : {std::pair(6.0, 0.01), {6.0, 1.0}, {12.0, 1.0}, {12.0, 2.0}, {4.0, 1.0}, {30.0, 1.0}})
    EXPECT_FALSE(snapshotPeriod(turning(turn, step))) << turn << " s a turn, steps of " << step << " s";
}

TEST(SnapshotFeed, TwoInstantsAreTooFewToTell) { EXPECT_FALSE(snapshotPeriod(snapshots(2))); }

TEST(SnapshotFeed, GivesEachInstantAllSectorsAndEachPlotItsOwn) {
  SnapshotFeed feed(snapshots(3), 6.0);
  std::size_t plots = 0;
  for (int running = 0; running < 3 * tws::kSectors; ++running) {
    ASSERT_TRUE(feed.nextTime());
    const int scan = running / tws::kSectors;
    const double instant = 6.0 * (scan + 1);
    EXPECT_LE(*feed.nextTime(), instant + 1e-9);
    const tws::RadarSector sector = feed.take();
    EXPECT_EQ(sector.running, running);
    EXPECT_GT(sector.leave_time, sector.enter_time);
    for (const tws::Plot& plot : sector.plots) {
      EXPECT_EQ(tws::sectorOf(plot.azimuth), sector.sector);
      EXPECT_NEAR(plot.time, instant, 1.1 * kSnapshotSweep);
      EXPECT_LE(plot.time, sector.leave_time);
      EXPECT_GE(plot.time, sector.enter_time);
    }
    plots += sector.plots.size();
  }
  EXPECT_FALSE(feed.nextTime());
  EXPECT_EQ(plots, 24u);
}

// A scan without plots must not look like a slower radar.
TEST(SnapshotFeed, CountsOnOverScansThatAreMissing) {
  SnapshotFeed feed({plotAt(6.0, 30e3), plotAt(24.0, 30e3)}, 6.0);
  for (int sector = 0; sector < tws::kSectors; ++sector) feed.take();
  EXPECT_EQ(feed.take().running, 3 * tws::kSectors);
}

}  // namespace
}  // namespace adit_tracker
