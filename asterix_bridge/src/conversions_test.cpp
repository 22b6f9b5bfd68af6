#include "conversions.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/units.h>

namespace asterix_bridge {
namespace {

CutSector sectorWith(const TargetReport& report) {
  CutSector sector;
  sector.sector = 63;
  sector.running = 127;
  sector.enter_time = 1000.0;
  sector.leave_time = 1000.0625;
  sector.period = 4.0;
  sector.reports.push_back({1000.03125, report});
  return sector;
}

TargetReport combinedReport() {
  TargetReport report;
  report.primary = report.secondary = true;
  report.range = 50000.0;
  report.azimuth = tws::radians(359.99);
  report.mode_3a = {true, true, false, false, 01234};
  report.flight_level = {true, true, false, 350.0};
  report.characteristics.primary_less_ssr_range = 1852.0 / 256.0;
  report.characteristics.primary_less_ssr_azimuth = tws::radians(360.0 / 16384.0);
  return report;
}

TEST(ToRadarSector, KeepsAllPlotsAsReported) {
  const tws::RadarSector sector = toRadarSector(sectorWith(combinedReport()), false);
  EXPECT_EQ(sector.running, 127);
  ASSERT_EQ(sector.plots.size(), 1u);
  EXPECT_DOUBLE_EQ(sector.plots[0].range, 50000.0);
  EXPECT_DOUBLE_EQ(sector.plots[0].time, 1000.03125);
}

// The primary radar's plot stands where the primary radar saw it, also across north.
TEST(ToRadarSector, MovesAPrimaryPlotToWhereThePrimaryRadarSawIt) {
  const tws::RadarSector sector = toRadarSector(sectorWith(combinedReport()), true);
  ASSERT_EQ(sector.plots.size(), 1u);
  EXPECT_DOUBLE_EQ(sector.plots[0].range, 50000.0 + 1852.0 / 256.0);
  EXPECT_NEAR(sector.plots[0].azimuth, tws::radians(359.99 + 360.0 / 16384.0 - 360.0), 1e-12);
}

TEST(ToRadarSector, DoesNotMoveItByADifferenceThatStandsForAllGreaterOnes) {
  TargetReport report = combinedReport();
  report.characteristics.primary_less_ssr_range = 127.0 * 1852.0 / 256.0;
  EXPECT_DOUBLE_EQ(toRadarSector(sectorWith(report), true).plots.at(0).range, 50000.0);
}

TEST(ToRadarSector, LeavesSecondaryPlotsOutOfThePrimarys) {
  TargetReport report = combinedReport();
  report.primary = false;
  EXPECT_TRUE(toRadarSector(sectorWith(report), true).plots.empty());
}

TEST(ToSsrPlots, TellsCodeAndHeight) {
  const tws_msgs::SsrPlots message = toSsrPlots(sectorWith(combinedReport()), "tower");
  EXPECT_EQ(message.header.stamp, ros::Time(1000, 62500000));
  EXPECT_EQ(message.header.frame_id, "tower");
  EXPECT_EQ(message.sector, 63);
  ASSERT_EQ(message.plots.size(), 1u);
  EXPECT_EQ(message.plots[0].mode_3a, 01234);
  EXPECT_NEAR(message.plots[0].height, 35000.0 * 0.3048, 1e-9);
  EXPECT_EQ(message.plots[0].mode_2, tws_msgs::SsrPlot::CODE_UNKNOWN);
}

// A code that the radar itself does not trust would name the wrong aircraft.
TEST(ToSsrPlots, DoesNotTellWhatIsNotValidated) {
  TargetReport report = combinedReport();
  report.mode_3a.validated = report.flight_level.validated = false;
  report.mode_3a.garbled = true;
  const tws_msgs::SsrPlot plot = toSsrPlots(sectorWith(report), "tower").plots.at(0);
  EXPECT_EQ(plot.mode_3a, tws_msgs::SsrPlot::CODE_UNKNOWN);
  EXPECT_TRUE(std::isnan(plot.height));
  EXPECT_EQ(plot.garbled, tws_msgs::SsrPlot::GARBLED_MODE_3A);
}

TEST(ToSectorMark, IsTheBeamsEntryIntoTheNextSector) {
  const tws_msgs::SectorMark mark = toSectorMark(sectorWith(combinedReport()), "tower", 1, 17);
  EXPECT_EQ(mark.header.stamp, ros::Time(1000, 62500000));
  EXPECT_EQ(mark.sector, 0);
  EXPECT_EQ(mark.running_sector, 128u);
  EXPECT_EQ(mark.closed_sector, 63);
  EXPECT_EQ(mark.closed_count, 1u);
  EXPECT_EQ(mark.running_count, 17u);
  EXPECT_DOUBLE_EQ(mark.rotation_period, 4.0);
}

// One minute of latitude is 1852 m within half a per cent, one of longitude at the equator as well.
TEST(ToTransform, PutsASiteWhereItIs) {
  const tws::LocalFrame map(tws::Geodetic{0.0, 0.0, 0.0});
  const auto transform =
      toTransform(map, tws::Geodetic{tws::radians(1.0 / 60.0), tws::radians(1.0 / 30.0), 100.0}, "map", "tower")
          .transform;
  EXPECT_NEAR(transform.translation.x, 3704.0, 20.0);
  EXPECT_NEAR(transform.translation.y, 1852.0, 10.0);
  EXPECT_NEAR(transform.translation.z, 100.0, 2.0);
  EXPECT_NEAR(transform.rotation.w, 1.0, 1e-6);
}

// The pole's neighbour: what is north at a site 90° of longitude away lies east or west in the map.
TEST(ToTransform, TurnsASiteToItsOwnNorth) {
  const tws::LocalFrame map(tws::Geodetic{tws::radians(89.999), 0.0, 0.0});
  const auto q =
      toTransform(map, tws::Geodetic{tws::radians(89.999), tws::radians(90.0), 0.0}, "map", "tower").transform.rotation;
  const double heading = std::atan2(2.0 * (q.w * q.z + q.x * q.y), 1.0 - 2.0 * (q.y * q.y + q.z * q.z));
  EXPECT_NEAR(heading, tws::radians(90.0), 1e-6);
}

}  // namespace
}  // namespace asterix_bridge
