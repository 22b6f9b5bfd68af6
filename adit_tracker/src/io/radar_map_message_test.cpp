#include "io/radar_map_message.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

// Rain of 20 false plots a scan at 30 km in sectors 10 and 11, one aircraft elsewhere. If this fails, the picture shows
// the rain in another place, or as much of it everywhere.
TEST(RadarMapMessage, ShowsWhereFalsePlotsComeFrom) {
  auto generator = tws::seededGenerator();
  const TestRadar radar(6.0);
  RadarSectors radars = {radar.sectors(0.0, 120.0)};
  radar.see({-60e3, -40e3, 200.0, 0.0}, radars[0]);
  for (tws::RadarSector& sector : radars[0]) {
    if (sector.sector != 10 && sector.sector != 11) continue;
    for (int i = 0; i < 10; ++i) {
      tws::Plot plot;
      plot.time = sector.enter_time + (i + 0.5) / 10.0 * (sector.leave_time - sector.enter_time);
      plot.range = tws::uniform(generator, 28e3, 32e3);
      plot.azimuth = tws::sectorStart(sector.sector) + (i + 0.5) / 10.0 * tws::kSectorWidth;
      sector.plots.push_back(plot);
    }
  }
  Listener listener(paramsFor("default", {6.0}));
  feedInOrder(listener.adit, radars);
  const tws_msgs::RadarMap map = radarMapMessage(listener.adit, 0);
  EXPECT_EQ(map.radar, "r0");
  ASSERT_EQ(map.false_plots.size(), static_cast<std::size_t>(tws_msgs::RadarMap::SECTORS) * map.bins);
  ASSERT_EQ(map.blind.size(), map.false_plots.size());
  EXPECT_NEAR(map.depth * map.bins, std::hypot(60e3, 40e3), 2e3);
  const auto greatest = std::max_element(map.false_plots.begin(), map.false_plots.end()) - map.false_plots.begin();
  const auto sector = greatest / map.bins;
  EXPECT_TRUE(sector == 10 || sector == 11) << sector;
  EXPECT_NEAR((static_cast<double>(greatest % map.bins) + 0.5) * map.depth, 30e3, map.depth);
  // 20 of them in 2 sectors × 4 km at 30 km.
  const double area = 2.0 * tws::kSectorWidth * 30.0 * 4.0;
  EXPECT_NEAR(static_cast<double>(map.false_plots[static_cast<std::size_t>(greatest)]), 20.0 / area, 15.0 / area);
  EXPECT_LT(map.false_plots[40U * map.bins + 10U], 0.1F * map.false_plots[static_cast<std::size_t>(greatest)]);
}

}  // namespace
}  // namespace adit_tracker
