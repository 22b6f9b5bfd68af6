#include "core/sector_intake.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/adit_test_helpers.h"
#include "core/plot_test_helpers.h"

namespace adit_tracker {
namespace {

class SectorIntakeTest : public testing::Test {
 protected:
  /// Sector `running` of the radar, 0.1 s a sector.
  tws::RadarSector sectorOf(std::int64_t running, const std::vector<tws::Plot>& plots = {}) const {
    tws::RadarSector sector;
    sector.running = running;
    sector.sector = static_cast<int>(running % tws::kSectors);
    sector.enter_time = 0.1 * static_cast<double>(running);
    sector.leave_time = sector.enter_time + 0.1;
    sector.plots = plots;
    return sector;
  }

  AditParams params_ = paramsFor("default", {6.4});
  Radars radars_{params_};
  Alignment alignment_{params_, radars_};
  AditCounts counts_;
  SectorIntake intake_{radars_, counts_, alignment_, 4};
};

// If this fails, one bad plot of a radar crashes the tracker or becomes a track.
TEST_F(SectorIntakeTest, LeavesOutWhatCannotBeUsedAndCountsIt) {
  intake_.add(0, sectorOf(10, {plotAt(1.05, std::nan(""), 0.05), plotAt(1.05, -1.0, 0.05), plotAt(0.5, 30e3, 0.05),
                               plotAt(1.05, 30e3, 0.05), plotAt(1.05, 30e3, 0.05)}));
  EXPECT_EQ(counts_.rejected_plots, 2U);
  EXPECT_EQ(counts_.late_plots, 1U);
  EXPECT_EQ(counts_.duplicate_plots, 1U);
  EXPECT_EQ(counts_.plots, 1U);
}

TEST_F(SectorIntakeTest, APlotThatCameInTheSectorBeforeIsACopy) {
  intake_.add(0, sectorOf(10, {plotAt(1.05, 30e3, 0.05)}));
  intake_.add(0, sectorOf(11, {plotAt(1.05, 30e3, 0.05), plotAt(1.15, 40e3, 0.05)}));
  EXPECT_EQ(counts_.duplicate_plots, 1U);
  EXPECT_EQ(counts_.plots, 2U);
}

// If this fails, the tracks depend on how much a radar has sent ahead by chance: a replay gives others than the run.
TEST_F(SectorIntakeTest, ASectorSeesNoMoreThanFourAhead) {
  for (std::int64_t running = 0; running < 10; ++running) intake_.add(0, sectorOf(running));
  intake_.admit({0, 2});
  EXPECT_EQ(radars_.at(0).detections.at(6).running, 6);
  EXPECT_EQ(radars_.at(0).detections.at(7).running, -1);
  EXPECT_EQ(radars_.antenna(0).newest(), 7);  // entered when sector 6 closed
}

}  // namespace
}  // namespace adit_tracker
