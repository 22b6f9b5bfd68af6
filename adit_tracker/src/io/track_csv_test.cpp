#include "io/track_csv.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

std::vector<std::vector<std::string>> rowsOf(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

/// An aircraft due east that flies north, seen until 100 s by a radar of 6 s.
class TrackCsvTest : public testing::Test {
 protected:
  void run(const std::string& set, double to) {
    adit_.emplace(paramsFor(set, {6.0}), [this](const SectorReport& r) { csv_.report(*adit_, r); });
    const TestRadar radar(6.0);
    auto sectors = radar.sectors(0.0, to);
    radar.see({30e3, -10e3, 0.0, 200.0, 0.0, 100.0}, sectors);
    for (const auto& sector : sectors) addAndProcess(*adit_, 0, sector);
    adit_->finish();
  }

  std::ostringstream text_;
  TrackCsv csv_{text_};
  std::optional<Adit> adit_;
};

TEST_F(TrackCsvTest, HasTheHeaderThatOtherProgramsRelyOn) {
  EXPECT_EQ(text_.str(), "t_s,track_id,x_m,y_m,vx_mps,vy_mps,status\n");
}

// Whoever reads the file without heights must find the columns that he knows.
TEST_F(TrackCsvTest, HeightsComeBehindTheUsualColumnsWhereTheyAreKnown) {
  std::ostringstream text;
  TrackCsv csv(text, true);
  adit_.emplace(paramsFor("default", {6.0}), [&](const SectorReport& r) { csv.report(*adit_, r); });
  const TestRadar radar(6.0);
  auto sectors = radar.sectors(0.0, 40.0);
  radar.see({30e3, -10e3, 0.0, 200.0}, sectors);
  for (auto& sector : sectors) {
    for (tws::Plot& plot : sector.plots) {
      if (plot.time > 20.0) plot.elevation = std::asin(0.2 - plot.range / (2.0 * 8494.7e3));
    }
    addAndProcess(*adit_, 0, sector);
  }
  adit_->finish();
  const auto rows = rowsOf(text.str());
  ASSERT_GT(rows.size(), 6U);
  EXPECT_EQ(rows[0].back(), "height_sigma_m");
  EXPECT_EQ(rows[1].size(), 8U);  // the last two are empty
  ASSERT_EQ(rows.back().size(), 9U);
  const double range = std::hypot(std::stod(rows.back()[2]), std::stod(rows.back()[3]));
  EXPECT_NEAR(std::stod(rows.back()[7]), 0.2 * range, 60.0);  // R sin e and the earth's curvature, which cancel here
}

TEST_F(TrackCsvTest, CovariancesComeLastAndSayHowFarATrackMayBeOff) {
  std::ostringstream text;
  TrackCsv csv(text, false, true);
  run("default", 98.0);
  csv.picture(*adit_, 98.0);
  csv.picture(*adit_, 118.0);
  const auto rows = rowsOf(text.str());
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0][7], "cov_x_x");
  EXPECT_EQ(rows[0].back(), "cov_vy_vy");
  ASSERT_EQ(rows[1].size(), 17U);
  const double now = std::sqrt(std::stod(rows[1][7])), later = std::sqrt(std::stod(rows[2][7]));
  EXPECT_GT(now, 20.0);
  EXPECT_LT(now, 200.0);
  EXPECT_GT(later, 2.0 * now);
  EXPECT_GT(std::stod(rows[1].back()), 0.0);
}

TEST_F(TrackCsvTest, CovariancesAreEmptyWhereTheFilterHasNone) {
  std::ostringstream text;
  TrackCsv csv(text, false, true);
  run("nrl7952", 98.0);
  csv.picture(*adit_, 98.0);
  EXPECT_EQ(text.str().substr(text.str().find(",firm") + 5), ",,,,,,,,,,\n");
}

// If this fails, whoever reads the file takes wrong tracks for good ones.
TEST_F(TrackCsvTest, HasARowForEveryUpdateAndMissWithItsStatusAndNothingAfterADrop) {
  run("nrl7952", 160.0);
  EXPECT_EQ(adit_->tracks().size(), 0U);
  const auto rows = rowsOf(text_.str());
  std::string sequence;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 7U);
    EXPECT_EQ(rows[i][1], rows[1][1]);
    sequence += rows[i][6][0];
  }
  // Seen at 1.5 + 6 k s: four times tentative (0, 6, 12, 18 s), firm from 24 s on, 17 plots; then coasting until it
  // has not been seen for 20 s.
  EXPECT_EQ(sequence, "ttttfffffffffffffccc");
  EXPECT_NEAR(std::stod(rows[10][2]), 30e3, 300.0);
  EXPECT_NEAR(std::stod(rows[10][3]), -10e3 + 200.0 * std::stod(rows[10][0]), 300.0);
  EXPECT_NEAR(std::stod(rows[17][5]), 200.0, 20.0);
}

TEST_F(TrackCsvTest, APictureHasTheBelievedTracksOnlyMovedOnToItsInstant) {
  run("default", 98.0);
  text_.str("");
  csv_.picture(*adit_, 104.0);
  const auto rows = rowsOf(text_.str());
  ASSERT_EQ(rows.size(), 1U);
  EXPECT_EQ(rows[0][0], "104.0000");
  EXPECT_NEAR(std::stod(rows[0][2]), 30e3, 100.0);
  EXPECT_NEAR(std::stod(rows[0][3]), -10e3 + 200.0 * 104.0, 100.0);
  EXPECT_EQ(rows[0][6], "firm");
}

TEST_F(TrackCsvTest, APictureLeavesTentativeTracksOut) {
  run("nrl7952", 15.0);
  EXPECT_EQ(adit_->tracks().size(), 1U);
  text_.str("");
  csv_.picture(*adit_, 16.0);
  EXPECT_EQ(text_.str(), "");
}

}  // namespace
}  // namespace adit_tracker
