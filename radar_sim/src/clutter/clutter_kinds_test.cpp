#include "clutter/clutter_kinds.h"

#include "scenario_file_test_helpers.h"
#include "simulated_run_test_helpers.h"

namespace radar_sim {
namespace {

/// One entry of each kind, which shows within 60 km; without braces.
const std::vector<std::pair<std::string, std::string>> kEntries{
    {"rain", "east_m: 10000, north_m: 5000, suppression_db: 25"},
    {"sea_clutter", "suppression_db: 30"},
    {"land_clutter", "suppression_db: 50"},
    {"wind_farms", "east_m: 8000, north_m: 0"},
    {"angels", "suppression_db: 0"},
    {"second_time_around", "true_range_m: [160000, 190000], suppression_db: 20"},
    {"anomalous_propagation", "suppression_db: 40"},
    {"jammers", "east_m: 0, north_m: 40000, height_m: 500, power_w: 20000"},
};

const std::string kRadars =
    "duration_s: 20\nradars:\n- {name: a, false_alarms_per_scan: 0, max_range_m: 60000}\n"
    "- {name: b, false_alarms_per_scan: 0, max_range_m: 60000}\n";
const std::string kTurned =
    "duration_s: 20\nradars:\n- {name: b, false_alarms_per_scan: 0, max_range_m: 60000}\n"
    "- {name: a, false_alarms_per_scan: 0, max_range_m: 60000}\n";

class ClutterKinds : public ScenarioFile {
 protected:
  static std::vector<double> ranges(const std::vector<tws_msgs::Detections>& sectors) {
    std::vector<double> all;
    for (const auto& sector : sectors)
      for (const auto& detection : sector.detections) all.push_back(detection.range);
    return all;
  }
  std::map<std::string, std::vector<double>> rangesByRadar(const std::string& content) {
    SimulatedRun run(load(content));
    run.toEnd();
    return {{"a", ranges(run.detections["a"])}, {"b", ranges(run.detections["b"])}};
  }
  static std::string entry(const std::pair<std::string, std::string>& kind, const std::string& more = "") {
    return kind.first + ":\n- {" + kind.second + more + "}\n";
  }
};

TEST_F(ClutterKinds, TheTableHasAnEntryHereForEachKind) {
  ASSERT_EQ(kEntries.size(), clutterKinds().size());
  for (std::size_t i = 0; i < kEntries.size(); ++i) EXPECT_EQ(kEntries[i].first, clutterKinds()[i].key);
}

// The same seed gives the same plots whoever stands first in the file; two radars see plots of their own.
TEST_F(ClutterKinds, PlotsAreTheSameInAnyOrderOfTheRadars) {
  for (const auto& kind : kEntries) {
    auto once = rangesByRadar(kRadars + entry(kind)), turned = rangesByRadar(kTurned + entry(kind));
    EXPECT_GT(once["a"].size(), 10u) << kind.first;
    EXPECT_EQ(once["a"], turned["a"]) << kind.first;
    EXPECT_EQ(once["b"], turned["b"]) << kind.first;
    EXPECT_NE(once["a"], once["b"]) << kind.first;
  }
}

TEST_F(ClutterKinds, OnlyTheRadarsThatAreNamedSeeIt) {
  for (const auto& kind : kEntries) {
    auto seen = rangesByRadar(kRadars + entry(kind, ", radars: [b]"));
    EXPECT_TRUE(seen["a"].empty()) << kind.first;
    EXPECT_FALSE(seen["b"].empty()) << kind.first;
  }
}

// What nobody is asked to track must not be counted as missed: evaluation leaves out clutter.
TEST_F(ClutterKinds, TheTruthHoldsOutlinesAsClutterAsLongAsItLasts) {
  SimulatedRun run(load(kRadars + "rain:\n- {name: shower, east_m: 1000, north_m: 0, end_s: 10}\n"
                                  "targets:\n- {name: alpha, east_m: 9000, north_m: 0}\n"));
  run.toEnd();
  const tws_msgs::Truth& early = run.truths().front();
  ASSERT_EQ(early.targets.size(), 37u);
  EXPECT_EQ(early.targets[1].name, "shower/0");
  for (std::size_t i = 1; i < early.targets.size(); ++i) {
    EXPECT_EQ(early.targets[i].kind, tws_msgs::TruthTarget::CLUTTER);
    EXPECT_EQ(early.targets[i].detection_probability, std::vector<double>(2, 0.0));
  }
  EXPECT_EQ(run.truths().back().targets.size(), 1u);
}

TEST_F(ClutterKinds, WhatIsWrongIsNamedWithItsLine) {
  expectComplaint("rain:\n- {rate_mm_h: 10}\n", 2, "east_m");
  expectComplaint("rain:\n- {east_m: 0, north_m: 0, rat_mm_h: 10}\n", 2, "rate_mm_h");
  expectComplaint("rain:\n- {east_m: 0, north_m: 0, rate_mm_h: 1000}\n", 2, "rate_mm_h");
  expectComplaint("rain:\n- {east_m: 0, north_m: 0, radars: [sps12]}\n", 2, "no rotating primary radar 'sps12'");
  expectComplaint("rain:\n- {name: a, east_m: 0, north_m: 0}\n- {name: a, east_m: 0, north_m: 0}\n", 3, "used twice");
  expectComplaint("sea_clutter:\n- {sea_state: 7}\n", 2, "sea_state");
  expectComplaint("sea_clutter:\n- {outline: [{east_m: 0, north_m: 0}]}\n", 2, "has 1 corners");
  expectComplaint("second_time_around:\n- {true_range_m: [100000, 140000]}\n", 2, "nothing to fold");
  expectComplaint("jammers:\n- {east_m: 0, north_m: 0, end_s: 0}\n", 2, "end_s");
  expectComplaint("radars:\n- {name: fine, pulse_width_s: 1.0e-9}\nrain:\n- {east_m: 0, north_m: 0}\n", 4,
                  "'fine' has more than 2000000 resolution cells");
}

}  // namespace
}  // namespace radar_sim
