#include "io/plot_csv.h"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

namespace adit_tracker {
namespace {

constexpr const char* kHeader = "t_s,radar,scan,range_m,az_deg\n";

PlotTable read(const std::string& text) {
  std::istringstream input(text);
  return readPlots(input, "plots.csv");
}

TEST(PlotCsv, ReadsPlotsOfEachRadarInOrderOfTime) {
  const PlotTable table = read(std::string(kHeader) + "2.5,b,0,1000,90\n1.5,a,0,2000.5,0\n0.5,b,0,3000,359.5\n");
  ASSERT_EQ(table.radars.size(), 2U);
  EXPECT_EQ(table.plots, 3U);
  const auto& b = table.radars.at("b");
  EXPECT_DOUBLE_EQ(b[0].time, 0.5);
  EXPECT_DOUBLE_EQ(b[1].range, 1000.0);
  EXPECT_NEAR(b[1].azimuth, 3.14159265358979 / 2.0, 1e-12);
  EXPECT_DOUBLE_EQ(table.radars.at("a")[0].range, 2000.5);
}

TEST(PlotCsv, WrapsAzimuthsOfAnyTurn) {
  const PlotTable table = read(std::string(kHeader) + "1,a,0,1000,-90\n2,a,0,1000,360\n");
  EXPECT_NEAR(table.radars.at("a")[0].azimuth, 1.5 * 3.14159265358979, 1e-12);
  EXPECT_NEAR(table.radars.at("a")[1].azimuth, 0.0, 1e-12);
}

TEST(PlotCsv, IgnoresFurtherColumnsBlanksAndEmptyLines) {
  const PlotTable table =
      read("t_s,radar,scan,range_m,az_deg,truth\r\n 1.0 , a ,7, 1000 ,10,x\r\n\r\n   \n2,a,,1000,10\n");
  EXPECT_EQ(table.plots, 2U);
  EXPECT_EQ(table.refused, 0U);
}

// 3-D radars say elevations; the report's EM39.
TEST(PlotCsv, ReadsElevationsWhereTheHeaderNamesThem) {
  const PlotTable table = read(
      "t_s,radar,scan,range_m,az_deg,src,el_deg,el_sigma_deg\n1,a,0,1000,10,x,30,0.2\n2,a,0,1000,10,x,,\n3,a,0,1000,"
      "10\n"
      "4,a,0,1000,10,x,91,\n5,a,0,1000,10,x,high,\n");
  EXPECT_TRUE(table.has_elevations);
  const auto& plots = table.radars.at("a");
  ASSERT_EQ(plots.size(), 3U);
  EXPECT_NEAR(plots[0].elevation, 3.14159265358979 / 6.0, 1e-12);
  EXPECT_NEAR(plots[0].elevation_sigma, 3.14159265358979 / 900.0, 1e-12);
  EXPECT_TRUE(std::isnan(plots[1].elevation));
  EXPECT_TRUE(std::isnan(plots[2].elevation));
  ASSERT_EQ(table.complaints.size(), 2U);
  EXPECT_EQ(table.complaints[0], "plots.csv:5: el_deg is out of range: 91");
  EXPECT_FALSE(read(std::string(kHeader) + "1,a,0,1000,10\n").has_elevations);
}

TEST(PlotCsv, ReadsRangeRatesWhereTheHeaderNamesThem) {
  const PlotTable table = read(
      "t_s,radar,range_m,az_deg,range_rate_mps\n1,a,1000,10,-33.5\n2,a,1000,10,\n3,a,1000,10,nan\n4,a,1000,10\n"
      "5,a,1000,10,2e5\n6,a,1000,10,fast\n7,a,1000,10,inf\n");
  EXPECT_TRUE(table.has_range_rates);
  const auto& plots = table.radars.at("a");
  ASSERT_EQ(plots.size(), 4U);
  EXPECT_DOUBLE_EQ(plots[0].range_rate, -33.5);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_TRUE(std::isnan(plots[i].range_rate));
  ASSERT_EQ(table.complaints.size(), 3U);
  EXPECT_EQ(table.complaints[0], "plots.csv:6: range_rate_mps is not in [-100000, 100000]: 2e5");
  EXPECT_FALSE(read(std::string(kHeader) + "1,a,0,1000,10\n").has_range_rates);
}

struct BadLine {
  const char* line;
  const char* reason;
};
class MalformedLine : public testing::TestWithParam<BadLine> {};

// If this fails, a damaged file is read wrongly without a word, or a good line after a bad one is lost.
TEST_P(MalformedLine, IsLeftOutAndNamedByFileAndLine) {
  const PlotTable table = read(std::string(kHeader) + "1,a,0,1000,10\n" + GetParam().line + "\n2,a,0,1000,10\n");
  EXPECT_EQ(table.plots, 2U);
  EXPECT_EQ(table.refused, 1U);
  ASSERT_EQ(table.complaints.size(), 1U);
  EXPECT_EQ(table.complaints[0], std::string("plots.csv:3: ") + GetParam().reason);
}

constexpr BadLine kBadLines[] = {
    {"1,a,0,1000", "az_deg is empty"},
    {"words", "t_s 'words' is no number"},
    {"0,5,a,0,1000,10", "6 values under 5 column names"},
    {",a,0,1000,10", "t_s is empty"},
    {"1x,a,0,1000,10", "t_s '1x' is no number"},
    {"1,a,0,abc,10", "range_m 'abc' is no number"},
    {"1,a,0,1000,", "az_deg is empty"},
    {"nan,a,0,1000,10", "t_s 'nan' is not finite"},
    {"1,a,0,inf,10", "range_m 'inf' is not finite"},
    {"1,a,0,1e999,10", "range_m '1e999' is no number"},
    {"1,a,0,0,10", "range_m is not positive: 0"},
    {"1,a,0,-5,10", "range_m is not positive: -5"},
    {"1,,0,1000,10", "radar is empty"},
    {"1e12,a,0,1000,10", "t_s is beyond 1e10 s: 1e12 (it counts seconds, not milliseconds)"},
    {"-2e10,a,0,1000,10", "t_s is beyond 1e10 s: -2e10 (it counts seconds, not milliseconds)"},
    {"5000000,a,0,1000,10", "t_s lies 4999998 s from most other plots: 5000000"},
    {"-700,a,0,1000,10", "t_s lies 701 s from most other plots: -700"},
};
INSTANTIATE_TEST_SUITE_P(Each, MalformedLine, testing::ValuesIn(kBadLines));

/// Plots of radar a, one a second.
std::string stretch(double from, int plots) {
  std::string text;
  for (int i = 0; i < plots; ++i) text += std::to_string(from + i) + ",a,0,1000,10\n";
  return text;
}

// If this fails, what was recorded before or after a pause is lost.
TEST(PlotCsv, KeepsAllOfARecordingThatPauses) {
  for (const double pause : {700.0, 3600.0, 86400.0, 20.0 * 86400.0}) {
    const PlotTable table =
        read(kHeader + stretch(100.0, 3) + stretch(100.0 + pause, 50) + stretch(200.0 + 2 * pause, 5));
    EXPECT_EQ(table.plots, 58U) << pause;
    EXPECT_EQ(table.refused, 0U) << pause;
  }
}

// If this fails, a clock that was wrong for a while makes the tracker walk through centuries of silence.
TEST(PlotCsv, LeavesOutAStretchThatIsMonthsAway) {
  const PlotTable table = read(kHeader + stretch(0.0, 4) + stretch(1.7e9, 50) + stretch(4.2e9, 5));
  EXPECT_EQ(table.plots, 50U);
  EXPECT_EQ(table.refused, 9U);
  EXPECT_EQ(table.radars.at("a").front().time, 1.7e9);
}

TEST(PlotCsv, TakesARadarWithFewPlotsWhenAnotherIsHeardMeanwhile) {
  const PlotTable table = read(kHeader + stretch(0.0, 2000) + "1000,b,0,5000,10\n");
  EXPECT_EQ(table.radars.at("b").size(), 1U);
}

// If this fails, a file of another kind floods the screen.
TEST(PlotCsv, CountsAllBadLinesButNamesOnlyTheFirst) {
  std::string text = kHeader;
  for (int i = 0; i < 1000; ++i) text += "bad\n";
  const PlotTable table = read(text);
  EXPECT_EQ(table.refused, 1000U);
  EXPECT_EQ(table.complaints.size(), 10U);
}

// If this fails, recordings that go over midnight lose half of their plots.
TEST(PlotCsv, TimesOfDayGoOnOverMidnight) {
  const PlotTable table =
      read(std::string(kHeader) + "86398,a,0,1000,10\n86399,b,0,1000,10\n1,a,0,1000,10\n5,b,0,1000,10\n");
  EXPECT_EQ(table.radars.at("a")[1].time, 86401.0);
  EXPECT_EQ(table.radars.at("b")[1].time, 86405.0);
  EXPECT_EQ(table.midnights, 1);
}

TEST(PlotCsv, RefusesAFileWithoutItsColumns) {
  for (const char* text : {"", "1,a,0,1000,10\n", "t_s,radar,range_m\n", "time;radar;range_m;az_deg\n"}) {
    try {
      read(text);
      FAIL() << "taken: " << text;
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).rfind("plots.csv:1: ", 0), 0U) << error.what();
    }
  }
}

}  // namespace
}  // namespace adit_tracker
