#include "clutter/clutter_csv.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <sstream>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>
#include <tws_core/temporary_folder_test_helpers.h>
#include <tws_core/units.h>

#include "clutter/damage_test_helpers.h"

namespace adit_tracker {
namespace {

constexpr const char* kHeader = "radar,range_m,az_deg\n";

ClutterLimits limits(std::uint32_t capacity = 1000, bool per_radar = true) {
  AditParams params;
  params.radars.resize(2);
  params.radars[0].name = "sps12";
  params.radars[1].name = "sps39";
  params.clutter.capacity = capacity;
  params.clutter.per_radar = per_radar;
  return ClutterLimits(params);
}

std::vector<ClutterPlace> read(const std::string& text, const ClutterLimits& taken = limits()) {
  std::istringstream input(text);
  return readClutter(input, "map.csv", taken).clutter;
}

std::string complaintAbout(const std::string& text, const ClutterLimits& taken = limits()) {
  try {
    read(text, taken);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

std::string written(const std::vector<ClutterPlace>& places) {
  std::ostringstream output;
  writeClutter(output, {places, {}});
  return output.str();
}

TEST(ClutterCsv, ReadsRangeAndAzimuthOfEachPointAndWhoseItIs) {
  const auto places =
      read(std::string("# by hand\n\n") + kHeader + "sps12,50000.5,90\r\n # the lighthouse\n*, 7 , 0.0 \n");
  ASSERT_EQ(places.size(), 2U);
  EXPECT_EQ(places[0].radar, "sps12");
  EXPECT_DOUBLE_EQ(places[0].range, 50000.5);
  EXPECT_NEAR(places[0].azimuth, 3.14159265358979 / 2.0, 1e-14);
  EXPECT_EQ(places[1], (ClutterPlace{"", 7.0, 0.0}));
}

struct BadFile {
  const char* text;
  const char* reason;
};
class MalformedClutter : public testing::TestWithParam<BadFile> {};

// If this fails, a map that was edited wrongly takes aircraft's detections away where its author did not mean to.
TEST_P(MalformedClutter, IsRefusedByFileLineAndReason) {
  EXPECT_EQ(complaintAbout(GetParam().text), std::string("map.csv:") + GetParam().reason);
}

constexpr BadFile kBadFiles[] = {
    {"", "1: is empty: the first line must name the columns"},
    {"# only words\n", "1: is empty: the first line must name the columns"},
    {"sps12,1000,10\n", "1: has no column radar (its columns are sps12,1000,10)"},
    {"radar,range_m,az_rad\n", "1: has no column az_deg (its columns are radar,range_m,az_rad)"},
    {"radar,range_m,az_deg\nsps12,1000,10\nsps12,1000\n", "3: az_deg is empty"},
    {"radar,range_m,az_deg\nsps12,1000,10,4\n", "2: 4 values under 3 column names"},
    {"radar,range_m,az_deg\n,1000,10\n", "2: radar is empty; * stands for all radars"},
    {"radar,range_m,az_deg\nsps10,1000,10\n", "2: there is no radar 'sps10'"},
    {"radar,range_m,az_deg\nsps12,nan,10\n", "2: range_m 'nan' is not finite"},
    {"radar,range_m,az_deg\nsps12,inf,10\n", "2: range_m 'inf' is not finite"},
    {"radar,range_m,az_deg\nsps12,-5,10\n", "2: range_m is not in (0, 1e7]: -5"},
    {"radar,range_m,az_deg\nsps12,0,10\n", "2: range_m is not in (0, 1e7]: 0"},
    {"radar,range_m,az_deg\nsps12,10000001,10\n", "2: range_m is not in (0, 1e7]: 10000001"},
    {"radar,range_m,az_deg\nsps12,1000,360\n", "2: az_deg is not in [0, 360): 360"},
    {"radar,range_m,az_deg\nsps12,1000,-1\n", "2: az_deg is not in [0, 360): -1"},
    {"radar,range_m,az_deg\nsps12,1000,NaN\n", "2: az_deg 'NaN' is not finite"},
    {"radar,range_m,az_deg\nsps12,1e3x,1\n", "2: range_m '1e3x' is no number"},
    {"radar,range_m,az_deg\nsps12,,1\n", "2: range_m is empty"},
};
INSTANTIATE_TEST_SUITE_P(Files, MalformedClutter, testing::ValuesIn(kBadFiles));

// Of two points, one number of three stays unused.
TEST(ClutterCsv, RefusesMorePointsThanAMapHolds) {
  const std::string two = std::string(kHeader) + "sps12,1000,1\nsps12,1000,2\n";
  EXPECT_EQ(complaintAbout(two + "sps39,1000,3\n", limits(3)), "");
  const std::string why = "more than 2 points in one map (clutter.capacity)";
  EXPECT_EQ(complaintAbout(two + "sps12,1000,3\n", limits(3)), "map.csv:4: " + why);
  EXPECT_EQ(complaintAbout(two + "*,1000,3\n", limits(3)), "map.csv:4: " + why);
  EXPECT_EQ(complaintAbout(two + "sps39,1000,3\n", limits(3, false)), "map.csv:4: " + why);
}

/// Anywhere, a third of them for all radars.
std::vector<ClutterPlace> randomPlaces(std::mt19937_64& generator) {
  std::vector<ClutterPlace> places(static_cast<std::size_t>(tws::uniformInt(generator, 0, 50)));
  for (ClutterPlace& place : places) {
    const char* const names[] = {"", "sps12", "sps39"};
    place.radar = names[tws::uniformInt(generator, 0, 2)];
    place.range = std::pow(10.0, tws::uniform(generator, -0.9, 7.0));
    place.azimuth = tws::uniform(generator, 0.0, tws::kTwoPi);
  }
  return places;
}

// If this fails, a map that is saved and loaded again and again wanders.
TEST(ClutterCsv, WhatIsWrittenIsReadBackAndThenStaysAsItIs) {
  auto generator = tws::seededGenerator();
  for (int i = 0; i < 500; ++i) {
    const auto places = randomPlaces(generator);
    const auto once = read(written(places));
    ASSERT_EQ(once.size(), places.size());
    for (std::size_t p = 0; p < places.size(); ++p) {
      EXPECT_EQ(once[p].radar, places[p].radar);
      EXPECT_NEAR(once[p].range, places[p].range, 0.0501);
      EXPECT_NEAR(tws::angularDifference(once[p].azimuth, places[p].azimuth), 0.0, tws::radians(0.0000501));
    }
    EXPECT_EQ(read(written(once)), once);
    EXPECT_EQ(written(once), written(places));
  }
}

TEST(ClutterCsv, WritesTheEdgesOfWhatIsAllowedSoThatTheyAreReadBack) {
  const auto edges = read(written({{"", 1e-9, tws::kTwoPi - 1e-12}, {"", 1e7, 0.0}}));
  ASSERT_EQ(edges.size(), 2U);
  EXPECT_DOUBLE_EQ(edges[0].range, 0.1);
  EXPECT_EQ(edges[0].azimuth, 0.0);
  EXPECT_DOUBLE_EQ(edges[1].range, 1e7);
}

// If this fails, a damaged file crashes the tracker, or lets places in that make no sense.
TEST(ClutterCsv, ADamagedFileIsReadOrRefusedInWords) {
  auto generator = tws::seededGenerator();
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    const std::string text = damaged(written(randomPlaces(generator)), generator);
    try {
      for (const ClutterPlace& place : read(text))
        EXPECT_TRUE(place.range > 0.0 && place.range <= 1e7 && place.azimuth >= 0.0 && place.azimuth < tws::kTwoPi);
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()).rfind("map.csv:", 0), 0U) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(refused, 100);
}

class ClutterFile : public testing::Test {
 protected:
  static std::string complaint(const std::function<void()>& act) {
    try {
      act();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  const tws::TemporaryFolder temporary_;
  const std::filesystem::path folder_ = temporary_.path();
  const std::string path_ = folder_ / "map.csv";
};

TEST_F(ClutterFile, IsReplacedAsAWholeAndNothingElseIsLeft) {
  saveClutterFile(path_, {{{"sps12", 1000.0, 1.0}, {"sps39", 2000.0, 2.0}}, {}});
  saveClutterFile(path_, {{{"sps12", 3000.0, 0.0}}, {}});
  EXPECT_EQ(loadClutterFile(path_, limits()).clutter, (std::vector<ClutterPlace>{{"sps12", 3000.0, 0.0}}));
  const std::filesystem::directory_iterator files(folder_);
  EXPECT_EQ(std::distance(begin(files), end(files)), 1);
}

// If this fails, what a disk that was full has left of a map is taken for all of it.
TEST_F(ClutterFile, ThatIsCutOffIsRefused) {
  RadarCounts counts;
  counts.radar = "sps12";
  counts.false_plots.at(3, 4) = {0.5F, 1.0F};
  saveClutterFile(path_, {{{"sps12", 1000.0, 1.0}}, {counts}});
  EXPECT_EQ(loadClutterFile(path_, limits()).radars, std::vector<RadarCounts>{counts});
  for (const unsigned lost : {2U, 19U}) {
    saveClutterFile(path_, {{{"sps12", 1000.0, 1.0}}, {counts}});
    std::filesystem::resize_file(path_, std::filesystem::file_size(path_) - lost);
    EXPECT_EQ(complaint([&] { loadClutterFile(path_, limits()); }),
              path_ + ": is cut off: its last line is not '# End of the map.'");
  }
}

// If this fails, an operator believes that the map is safe.
TEST_F(ClutterFile, ThatCannotBeWrittenOrReadIsNamed) {
  const std::string nowhere = folder_ / "absent" / "map.csv";
  EXPECT_EQ(complaint([&] { saveClutterFile(nowhere, {}); }),
            nowhere + ": cannot be written: No such file or directory");
  EXPECT_EQ(complaint([&] { loadClutterFile(nowhere, limits()); }),
            nowhere + ": cannot be read: No such file or directory");
  EXPECT_EQ(complaint([&] { saveClutterFile(folder_, {}); }),
            folder_.string() + ": cannot be written: it exists and is no regular file");
  EXPECT_EQ(complaint([&] { loadClutterFile(folder_, limits()); }),
            folder_.string() + ": cannot be read: it is no regular file");
}

}  // namespace
}  // namespace adit_tracker
