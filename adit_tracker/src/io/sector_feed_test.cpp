#include "io/sector_feed.h"

#include <gtest/gtest.h>

#include <tws_core/random_test_helpers.h>
#include <tws_core/sectors.h>

#include "core/plot_test_helpers.h"

namespace adit_tracker {
namespace {

std::vector<tws::RadarSector> allOf(SectorFeed& feed) {
  std::vector<tws::RadarSector> sectors;
  while (feed.nextTime()) sectors.push_back(feed.take());
  return sectors;
}

// A turn of 6.4 s from north at t = 0: sector i covers [0.1 i, 0.1 (i + 1)).
TEST(SectorFeed, CutsPlotsIntoTheSectorsThatTheBeamCrossed) {
  SectorFeed feed({plotAt(0.25, 1e3), plotAt(0.29, 1e3), plotAt(0.51, 1e3)}, tws::Rotation::uniform(6.4, 0.0));
  EXPECT_NEAR(*feed.nextTime(), 0.3, 1e-9);
  const auto sectors = allOf(feed);
  ASSERT_EQ(sectors.size(), 4U);  // 2, 3, 4, 5: empty ones too.
  EXPECT_EQ(sectors[0].running, 2);
  EXPECT_EQ(sectors[0].plots.size(), 2U);
  EXPECT_EQ(sectors[1].plots.size(), 0U);
  EXPECT_EQ(sectors[3].running, 5);
  EXPECT_EQ(sectors[3].plots.size(), 1U);
  EXPECT_NEAR(sectors[3].enter_time, 0.5, 1e-9);
  EXPECT_NEAR(sectors[3].leave_time, 0.6, 1e-9);
}

TEST(SectorFeed, CountsOnAcrossNorth) {
  SectorFeed feed({plotAt(6.35, 1e3), plotAt(6.45, 1e3)}, tws::Rotation::uniform(6.4, 0.0));
  const auto sectors = allOf(feed);
  ASSERT_EQ(sectors.size(), 2U);
  EXPECT_EQ(sectors[0].running, 63);
  EXPECT_EQ(sectors[1].running, 64);
  EXPECT_EQ(sectors[1].sector, 0);
}

// If this fails, files whose time is that of the day (or negative) give no or wrong sectors.
TEST(SectorFeed, StartsItsRunningNumbersInTheFirstTurnAtAnyTime) {
  for (const double start : {1.7e9, 86399.0, 0.0, -5000.0}) {
    SectorFeed feed({plotAt(start + 0.05, 1e3), plotAt(start + 20.0, 1e3)}, tws::Rotation::uniform(6.0, 1.0));
    const auto sectors = allOf(feed);
    EXPECT_GE(sectors.front().running, 0);
    EXPECT_LT(sectors.front().running, tws::kSectors);
    EXPECT_NEAR(static_cast<double>(sectors.size()), 20.0 / (6.0 / 64.0), 1.5);
  }
}

// If this fails, plots vanish between the file and the tracker.
TEST(SectorFeed, LosesNoPlotAndRepeatsNone) {
  auto generator = tws::seededGenerator();
  for (int run = 0; run < 50; ++run) {
    const double period = tws::uniform(generator, 0.5, 15.0);
    std::vector<tws::Plot> plots;
    double time = tws::uniform(generator, -100.0, 100.0);
    for (int i = tws::uniformInt(generator, 1, 200); i > 0; --i) {
      time += 0.008 * tws::uniformInt(generator, 0, 100);  // Quantised: some fall on borders, some together.
      plots.push_back(plotAt(time, 1e3));
    }
    SectorFeed feed(plots, tws::Rotation::uniform(period, tws::uniform(generator, 0.0, 6.0)));
    std::size_t next = 0;
    std::int64_t running = -1;
    for (const tws::RadarSector& sector : allOf(feed)) {
      if (running >= 0) {
        ASSERT_EQ(sector.running, running + 1);
      }
      running = sector.running;
      ASSERT_EQ(sector.sector, sector.running % 64);
      for (const tws::Plot& plot : sector.plots) {
        ASSERT_DOUBLE_EQ(plot.time, plots.at(next++).time);
        ASSERT_GE(plot.time, sector.enter_time - 1e-9);
        ASSERT_LT(plot.time, sector.leave_time);
      }
    }
    ASSERT_EQ(next, plots.size());
  }
}

}  // namespace
}  // namespace adit_tracker
