#include "clutter/radar_counts_csv.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include <tws_core/random_test_helpers.h>

#include "clutter/clutter_csv.h"

#include "clutter/damage_test_helpers.h"

namespace adit_tracker {
namespace {

const std::string kHeader = std::string("radar,range_m,az_deg") + kRadarCountsColumns + "\n";

ClutterLimits limits() {
  AditParams params;
  params.radars.resize(2);
  params.radars[0].name = "sps12";
  params.radars[1].name = "sps39";
  return ClutterLimits(params);
}

SavedMaps read(const std::string& text) {
  std::istringstream input(text);
  return readClutter(input, "map.csv", limits());
}

std::string complaintAbout(const std::string& text) {
  try {
    read(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

std::string written(const SavedMaps& maps) {
  std::ostringstream output;
  writeClutter(output, maps);
  return output.str();
}

/// Of 200 km; three cells in four have shown something.
RadarCounts randomCounts(const std::string& radar, std::mt19937_64& generator) {
  RadarCounts counts;
  counts.radar = radar;
  counts.greatest_range = 198765.4;
  counts.false_plots.depth = counts.cover.depth = 5000.0;
  for (CellCounts* cells : {&counts.false_plots, &counts.cover}) {
    for (CellCount& cell : cells->cells) {
      if (tws::uniformInt(generator, 0, 3) == 0) continue;
      cell.looks = static_cast<float>(tws::uniform(generator, 0.0, 7.5));
      cell.count = static_cast<float>(tws::uniform(generator, 0.0, static_cast<double>(cell.looks)));
    }
  }
  return counts;
}

// If this fails, a map that is saved and loaded again and again wanders, or points are lost among the cells.
TEST(RadarCountsCsv, WhatIsWrittenIsReadBackAndThenStaysAsItIs) {
  auto generator = tws::seededGenerator();
  const SavedMaps maps{{{"sps39", 1000.0, 1.0}}, {randomCounts("sps12", generator), randomCounts("sps39", generator)}};
  const SavedMaps once = read(written(maps));
  EXPECT_EQ(once.clutter.size(), 1U);
  ASSERT_EQ(once.radars.size(), 2U);
  EXPECT_EQ(once.radars[1].radar, "sps39");
  EXPECT_DOUBLE_EQ(once.radars[1].greatest_range, 198765.4);
  EXPECT_DOUBLE_EQ(once.radars[1].false_plots.depth, 5000.0);
  for (std::size_t i = 0; i < CellCounts::kCells; ++i) {
    EXPECT_NEAR(once.radars[1].false_plots.cells[i].count, maps.radars[1].false_plots.cells[i].count, 0.00051F);
    EXPECT_NEAR(once.radars[1].cover.cells[i].looks, maps.radars[1].cover.cells[i].looks, 0.0051F);
  }
  EXPECT_EQ(read(written(once)).radars, once.radars);
  EXPECT_LT(written(maps).size(), 1U << 20U);
}

TEST(RadarCountsCsv, BinsOfBothKindsMayDiffer) {
  RadarCounts counts;
  counts.radar = "sps12";
  counts.greatest_range = 500e3;
  counts.false_plots.depth = 10e3;
  counts.false_plots.at(63, 49) = {0.5F, 1.0F};
  counts.cover.at(3, 64) = {0.0F, 2.0F};
  EXPECT_EQ(read(written({{}, {counts}})).radars, std::vector<RadarCounts>{counts});
}

// If this fails, whoever has nothing but points finds columns without a meaning in the file.
TEST(RadarCountsCsv, AFileWithoutCellsIsAsItWas) {
  EXPECT_NE(written({{{"", 1000.0, 0.0}}, {}}).find("\nradar,range_m,az_deg\n*,1000.0,0.0000\n"), std::string::npos);
}

struct BadRow {
  const char* row;
  const char* reason;
};
class MalformedCell : public testing::TestWithParam<BadRow> {};

// If this fails, a map that is damaged or of another radar makes the tracker blind or credulous somewhere.
TEST_P(MalformedCell, IsRefusedByFileLineAndReason) {
  const std::string good = "sps12,0,0,2500,150000,0.5,1\n";
  EXPECT_EQ(complaintAbout(kHeader + good + GetParam().row + "\n"), std::string("map.csv:3: ") + GetParam().reason);
}

constexpr BadRow kBadRows[] = {
    {"sps10,0,5.625,2500,150000,0.5,1", "there is no radar 'sps10'"},
    {"*,0,5.625,2500,150000,0.5,1", "a cell with depth_m is of one radar, not of all (*)"},
    {"sps12,0,0,2500,150000,0.5,1", "the cell has been told already"},
    {"sps12,0,5.625,2500,150000,0.5", "a cell with depth_m wants scans or looks"},
    {"sps12,0,5.625,2500,150000,,1", "false_plots is empty"},
    {"sps12,0,5.625,2500,,0.5,1", "greatest_range_m is empty"},
    {"sps12,0,5.625,2500,,,,1", "a cell with depth_m wants scans or looks"},
    {"sps12,0,5.625,2500,,,,,1", "seen is empty"},
    {"sps12,0,5.625,2500,,,,2,1", "seen is not in [0, looks]: 2"},
    {"sps12,0,5.625,2500,,,,0,1e300", "looks is not in [0, 1e5]: inf"},
    {"sps12,0,5.625,2500,150000,-1,1", "false_plots is not in [0, 1e5]: -1"},
    {"sps12,0,5.625,2500,150000,nan,1", "false_plots 'nan' is not finite"},
    {"sps12,0,5.625,2500,150000,1,1e9", "scans is not in [0, 100]: 1000000000"},
    {"sps12,0,5.625,2500,149999,1,1", "greatest_range_m is not that of the radar's other cells"},
    {"sps39,0,5.625,2500,200001,1,1", "greatest_range_m is not in [10000, 64 depth_m]: 200001"},
    {"sps39,0,5.625,2500,-5,1,1", "greatest_range_m is not in [10000, 64 depth_m]: -5"},
    {"sps12,0,5.625,5000,150000,1,1", "depth_m is not that of the radar's other cells: 5000"},
    {"sps12,0,5.625,3000,150000,1,1", "depth_m is not 156.25 times 1, 2, 4, ... 1024: 3000"},
    {"sps12,0,5.625,320000,150000,1,1", "depth_m is not 156.25 times 1, 2, 4, ... 1024: 320000"},
    {"sps12,0,5.625,0,150000,1,1", "depth_m is not 156.25 times 1, 2, 4, ... 1024: 0"},
    {"sps12,0,5.6,2500,150000,1,1", "az_deg is not where a sector begins, a multiple of 5.625: 5.6"},
    {"sps12,0,360,2500,150000,1,1", "az_deg is not where a sector begins, a multiple of 5.625: 360"},
    {"sps12,1000,5.625,2500,150000,1,1", "range_m is not where a cell begins, 0 to 64 times depth_m: 1000"},
    {"sps12,-2500,5.625,2500,150000,1,1", "range_m is not where a cell begins, 0 to 64 times depth_m: -2500"},
    {"sps12,162500,5.625,2500,150000,1,1", "range_m is not where a cell begins, 0 to 64 times depth_m: 162500"},
};
INSTANTIATE_TEST_SUITE_P(Rows, MalformedCell, testing::ValuesIn(kBadRows));

TEST(RadarCountsCsv, AFileThatLacksAColumnOfCellsIsRefused) {
  EXPECT_EQ(complaintAbout("radar,range_m,az_deg,depth_m\nsps12,0,0,2500\n"),
            "map.csv:1: has no column greatest_range_m (its columns are radar,range_m,az_deg,depth_m)");
}

// If this fails, a damaged file crashes the tracker.
TEST(RadarCountsCsv, ADamagedFileIsReadOrRefusedInWords) {
  auto generator = tws::seededGenerator();
  std::string whole = written({{}, {randomCounts("sps12", generator)}});
  whole.resize(whole.find('\n', 3000) + 1);
  int refused = 0;
  for (int i = 0; i < 2000; ++i) {
    const std::string text = damaged(whole, generator);
    try {
      for (const RadarCounts& counts : read(text).radars) EXPECT_EQ(problemOf(counts), "");
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).rfind("map.csv:", 0), 0U) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace adit_tracker
