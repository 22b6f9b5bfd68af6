#include "report_csv.h"

#include <gtest/gtest.h>

#include <sstream>

namespace asterix_bridge {
namespace {

TargetReport reportAt(double azimuth_deg) {
  TargetReport report;
  report.source = SourceId{20, 130};
  report.secondary = true;
  report.range = 9780.875;
  report.azimuth = azimuth_deg * 3.14159265358979323846 / 180.0;
  return report;
}

// Other programs read this file by its columns.
TEST(PlotCsv, WritesAPlotALineWithTimesFromTheFirstOneOn) {
  std::ostringstream out;
  PlotCsv csv(out);
  TargetReport report = reportAt(175.8472);
  report.mode_3a = {true, true, false, false, 02270};
  report.flight_level = {true, true, false, 221.25};
  report.aircraft_address = 0x4CA152;
  report.callsign = {'A', 'B', 'C', '\0'};
  report.track_number = 7;
  csv.add(report, 1000.0);
  TargetReport doubtful = reportAt(180.0);
  doubtful.mode_3a = {true, true, true, false, 07700};
  doubtful.flight_level = {true, false, false, -12.0};
  csv.add(doubtful, 1000.5);
  EXPECT_EQ(out.str(),
            "t_s,radar,scan,range_m,az_deg,mode3a,fl,address,callsign,track\n"
            "0.0000,radar_20_130,0,9780.9,175.8472,2270,221.25,4CA152,ABC,7\n"
            "0.5000,radar_20_130,0,9780.9,180.0000,,,,,\n");
}

TEST(PlotCsv, CountsTurns) {
  std::ostringstream out;
  PlotCsv csv(out);
  for (const double azimuth : {100.0, 200.0, 350.0, 1.0, 359.9, 2.0, 170.0, 300.0, 10.0})
    csv.add(reportAt(azimuth), 0.0);
  std::string scans;
  std::istringstream lines(out.str());
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) scans += line[line.find("130,") + 4];
  EXPECT_EQ(scans, "000101112");
}

// One aircraft flying against the sense of rotation is seen once a turn.
TEST(PlotCsv, CountsTurnsWithOnePlotEachByTheirTime) {
  std::ostringstream out;
  PlotCsv csv(out, {{SourceId{20, 130}, 4.0}});
  for (int turn = 0; turn < 10; ++turn) csv.add(reportAt(60.0 - 2.0 * turn), 100.0 + 3.98 * turn);
  EXPECT_NE(out.str().find(",radar_20_130,9,"), std::string::npos) << out.str();
  EXPECT_EQ(out.str().find(",radar_20_130,-1,"), std::string::npos);
}

TEST(PlotCsv, LeavesOutWhatIsNoMeasurement) {
  std::ostringstream out;
  PlotCsv csv(out);
  TargetReport coasted = reportAt(10.0);
  coasted.secondary = false;
  csv.add(coasted, 0.0);
  csv.add(reportAt(10.0), kUnknown);
  EXPECT_EQ(csv.leftOut(), 2u);
}

}  // namespace
}  // namespace asterix_bridge
