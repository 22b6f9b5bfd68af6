#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include <tws_core/units.h>
#include <tws_runtime/parameters.h>

#include "radar_presets.h"
#include "rotating_sensor.h"
#include "scenario.h"
#include "scenario_file_test_helpers.h"
#include "simulated_run_test_helpers.h"

namespace radar_sim {
namespace {

TEST_F(ScenarioFile, MayBeEmpty) {
  const Scenario scenario = load("");
  EXPECT_EQ(scenario.seed, 1u);
  EXPECT_EQ(scenario.start_time, 1000.0);
  EXPECT_EQ(scenario.duration, 300.0);
  EXPECT_TRUE(scenario.sensors.empty());
}

// A ship's scenario under a name of the user's own would be tracked with an aircraft's parameters.
TEST_F(ScenarioFile, SaysWhichParametersItsTrackersNeedAndLeavesTheirMeaningToThoseWhoStartThem) {
  const Scenario scenario = load(R"(
trackers:
  range_gate_tracker: ship
  window_tracker: {radar: sps12, parameters: [a, b]}
)");
  ASSERT_EQ(scenario.trackers.size(), 2u);
  EXPECT_EQ(scenario.trackers["range_gate_tracker"].as<std::string>(), "ship");
  EXPECT_EQ(scenario.trackers["window_tracker"]["radar"].as<std::string>(), "sps12");
  EXPECT_EQ(scenario.trackers["range_gate_tracker"].Mark().line, 2);  // for errors of those who read it
  for (const char* none : {"", "trackers:\n", "trackers: {}\n"}) {
    EXPECT_TRUE(load(none).trackers.IsMap()) << none;
    EXPECT_EQ(load(none).trackers.size(), 0u) << none;
  }
  expectComplaint("seed: 1\ntrackers: ship\n", 2, "trackers");
  expectComplaint("trackers: {a: ship, a: boat}\n", 1, "a");
}

TEST_F(ScenarioFile, IsReadInItsUnits) {
  const Scenario scenario = load(R"(
seed: 42
duration_s: 90
start_time_s: 500
truth_period_s: 2
origin: {latitude_deg: 48, longitude_deg: 11, altitude_m: 10}
sites:
  - {name: ship}
  - {name: island, latitude_deg: 48, longitude_deg: 11.1}
radars:
  - name: sps39
    type: SPS-39
    site: island
    start_azimuth_deg: 90
    antenna_gain_db: 33
    false_alarms_by: cell
    beams:
      - {elevation_deg: 2, beamwidth_deg: 4, cosecant_to_deg: 30}
targets:
  - {name: alpha, east_m: 1000, north_m: 2000, height_m: 3000, course_deg: 90, speed_kn: 400, rcs_m2: 7, swerling: 3, start_s: 10, end_s: 60}
clutter:
  - {name: rock, range_m: 20000, azimuth_deg: 90, detection_probability: 0.5}
  - {name: wreck, range_m: 30000, azimuth_deg: 90, start_s: 5, end_s: 25}
random_slow_movers:
  - {name: boats, count: 3, speed_kn: [10, 20], start_s: 15}
faults:
  - {type: outage, radar: sps39, from_s: 20, to_s: 30}
)");
  EXPECT_EQ(scenario.seed, 42u);
  EXPECT_DOUBLE_EQ(scenario.endTime(), 590.0);
  EXPECT_DOUBLE_EQ(scenario.origin.latitude, tws::radians(48.0));
  EXPECT_NEAR(scenario.sites[1].position.x(), 7460.0, 10.0);  // 0.1° · 111.41 km · cos 48°
  const RadarParams& radar = dynamic_cast<const RotatingSpec&>(*scenario.sensors.at(0)).params;
  EXPECT_DOUBLE_EQ(radar.rotation_period, 8.0);
  EXPECT_DOUBLE_EQ(radar.start_azimuth, tws::radians(90.0));
  EXPECT_NEAR(radar.antenna_gain, 1995.26, 0.01);
  EXPECT_FALSE(radar.false_alarms_by_area);
  ASSERT_EQ(radar.beams.size(), 1u);
  EXPECT_DOUBLE_EQ(radar.beams[0].cosecant_to, tws::radians(30.0));
  const Target& alpha = scenario.targets.at(0);
  EXPECT_EQ(alpha.reflection.rcs, 7.0);
  EXPECT_EQ(alpha.reflection.fluctuation, Fluctuation::kOneDominant);
  EXPECT_EQ(alpha.trajectory->spans()[0].start, 510.0);
  EXPECT_EQ(alpha.trajectory->spans()[0].end, 560.0);
  EXPECT_NEAR(alpha.trajectory->at(520.0).position.x(), 1000.0 + 10.0 * 400.0 * 0.514444, 0.01);
  EXPECT_NEAR(scenario.targets.at(1).trajectory->at(500.0).position.x(), 20000.0, 1e-6);
  EXPECT_FALSE(scenario.targets.at(2).trajectory->existsAt(504.0));
  EXPECT_TRUE(scenario.targets.at(2).trajectory->existsAt(505.5));
  EXPECT_FALSE(scenario.targets.at(2).trajectory->existsAt(526.0));
  EXPECT_NEAR(scenario.groups.at(0).speed.greatest, 10.2889, 1e-3);
  EXPECT_EQ(scenario.groups.at(0).life.start, 515.0);
  EXPECT_EQ(scenario.faults.at(0).from, 520.0);
}

TEST_F(ScenarioFile, YieldsToOverrides) {
  load("seed: 3\nduration_s: 100\n");
  const Scenario scenario = loadScenario(path_, {9u, 20.0});
  EXPECT_EQ(scenario.seed, 9u);
  EXPECT_EQ(scenario.duration, 20.0);
}

// A slip in a scenario that passes in silence makes a study of something else than its author thinks.
TEST_F(ScenarioFile, IsRefusedWithLineAndReason) {
  expectComplaint("seed: 1\nduraton_s: 5\n", 2, "did you mean 'duration_s'?");
  expectComplaint("duration_s: 0\n", 1, "duration_s: 0 is not in [1, 1000000]");
  expectComplaint("seed: one\n", 1, "expected a whole number");
  expectComplaint("seed: -1\n", 1, "seed");
  expectComplaint("seed: 1\nseed: 2\n", 2, "twice");
  expectComplaint("origin:\n  latitude_deg: 95\n", 2, "origin.latitude_deg: 95 is not in [-90, 90]");
  expectComplaint("origin: [1, 2]\n", 1, "expected a map");
  expectComplaint("sites:\n  - {name: a}\n  - {name: a}\n", 3, "used twice");
  expectComplaint("radars: sps12\n", 1, "list");
  expectComplaint("seed: [1\n", 2, "");
}

TEST_F(ScenarioFile, IsRefusedForAWrongRadar) {
  expectComplaint("radars:\n  - {type: SPS-12}\n", 2, "name: is required");
  expectComplaint("radars:\n  - {name: 12sps}\n", 2, "cannot be a topic's name");
  expectComplaint("radars:\n  - {name: map}\n", 2, "frame");
  expectComplaint("radars:\n  - name: a\n    type: SPS-13\n", 3,
                  "'SPS-13' is not one of SPS-12, SPS-39, SPS-10, generic");
  expectComplaint("radars:\n  - name: a\n    rotation_period_s: -6\n", 3, "is not in [0.7, 600]");
  expectComplaint("radars:\n  - name: a\n    rotation_period_s: .nan\n", 3, "expected a number");
  expectComplaint("radars:\n  - name: a\n    site: moon\n", 3, "there is no site 'moon'");
  expectComplaint("sites: [{name: a}, {name: b}]\nradars:\n  - {name: a}\n", 3, "several sites");
  expectComplaint("radars:\n  - {name: a}\n  - {name: a}\n", 3, "used twice");
  expectComplaint("radars:\n  - name: a\n    max_range_m: 500\n    min_range_m: 900\n", 3,
                  "is not greater than min_range_m");
  expectComplaint("radars:\n  - name: a\n    time_lsb_s: 0.2\n", 3, "time_lsb_s: 0.2 is not in");
  expectComplaint("radars:\n  - name: a\n    beams: []\n", 3, "empty");
  expectComplaint("radars:\n  - name: a\n    beams:\n      - {elevation_deg: 2}\n", 4, "beamwidth_deg: is required");
  expectComplaint("radars:\n  - name: a\n    gain: 3\n", 3, "not a known key");
}

TEST_F(ScenarioFile, IsRefusedForAWrongTarget) {
  const std::string alpha = "targets:\n  - name: alpha\n";
  expectComplaint(alpha, 2, "east_m: is required");
  expectComplaint(alpha + "    east_m: 5\n", 3, "needs north_m beside it");
  expectComplaint(alpha + "    east_m: 5\n    north_m: 5\n    range_m: 5\n    azimuth_deg: 5\n", 5, "given twice");
  const std::string placed = alpha + "    east_m: 5\n    north_m: 5\n";
  expectComplaint(placed + "    kind: ufo\n", 5, "'ufo' is not one of");
  expectComplaint(placed + "    swerling: 2\n", 5, "not modelled");
  expectComplaint(placed + "    speed_mps: 5\n    speed_kn: 5\n", 6, "one of them only");
  expectComplaint(placed + "    rcs_m2: 5\n    detection_probability: 0.5\n", 6, "one of them only");
  expectComplaint(placed + "    start_s: 9\n    end_s: 5\n", 6, "not later than start_s");
  expectComplaint(placed + "    speed_mps: 10\n    legs:\n      - {duration_s: 10, acceleration_mps2: -2}\n", 7,
                  "makes the speed negative");
  expectComplaint(placed + "    legs:\n      - {turn_rate_deg_s: 2}\n", 6, "duration_s: is required");
  expectComplaint(placed + "    legs:\n      - {duration_s: 5, turn_rate_deg_s: 0.0001}\n", 6,
                  "too small to be a turn");
  expectComplaint(alpha + "    waypoints:\n      - {east_m: 0, north_m: 0, speed_mps: 9}\n", 4, "two waypoints");
  expectComplaint(alpha + "    waypoints:\n      - {east_m: 0, north_m: 0}\n", 4, "speed above 0");
  expectComplaint(alpha + "    recording: {file: nowhere.csv}\n", 3, "nowhere.csv: cannot be read");
  expectComplaint(alpha + "    recording: {from_s: 1}\n", 3, "file: is required");
  expectComplaint("targets:\n  - {name: a, east_m: 0, north_m: 0}\n  - {name: a, east_m: 0, north_m: 0}\n", 3,
                  "used twice");
  expectComplaint("clutter:\n  - {name: a, east_m: 0, north_m: 0, speed_mps: 4}\n", 2, "not a known key");
  expectComplaint("clutter:\n  - {name: a, east_m: 0, north_m: 0, start_s: 4, end_s: 3}\n", 2,
                  "not later than start_s");
}

TEST_F(ScenarioFile, IsRefusedForAWrongGroupOrFault) {
  expectComplaint("random_aircraft:\n  - {name: a}\n", 2, "count: is required");
  expectComplaint("random_aircraft:\n  - count: 2\n    speed_mps: [300, 100]\n", 3, "first number is greater");
  expectComplaint("random_aircraft:\n  - count: 2\n    speed_mps: 300\n", 3, "list of numbers");
  expectComplaint("random_aircraft:\n  - count: 2\n    height_m: [1, 2, 3]\n", 3, "two numbers");
  expectComplaint("random_slow_movers:\n  - count: 2\n    speed_kn: [5, 80]\n", 3, "80 is not in [0, 50]");
  expectComplaint("random_clutter:\n  - {count: 2}\n  - {count: 3}\n", 3, "used twice");
  const std::string radar = "radars: [{name: a}]\nfaults:\n";
  expectComplaint(radar + "  - {type: outage, radar: b, from_s: 1, to_s: 2}\n", 3, "'b' is not one of a");
  expectComplaint(radar + "  - {type: fire, radar: a, from_s: 1, to_s: 2}\n", 3, "'fire' is not one of");
  expectComplaint(radar + "  - {type: outage, radar: a, from_s: 3, to_s: 2}\n", 3, "not later than from_s");
  expectComplaint(radar + "  - {type: outage, radar: a, from_s: 1}\n", 3, "to_s: is required");
  expectComplaint(radar + "  - {type: false_alarm_burst, radar: a, from_s: 1, to_s: 2}\n", 3,
                  "false_alarms_per_scan: is required");
}

TEST_F(ScenarioFile, ThatIsMissingIsNamed) {
  try {
    loadScenario("/nowhere/scenario.yaml");
    FAIL();
  } catch (const tws_runtime::ParameterError& error) {
    EXPECT_NE(std::string(error.what()).find("/nowhere/scenario.yaml"), std::string::npos);
  }
}

// The names that launch files and the command know; each must start as it is shipped.
TEST(ShippedScenarios, AllRun) {
  for (const char* name : {"adit_nominal", "bel_dense", "doppler", "full", "one_aircraft", "real_flight"}) {
    SimulatedRun run(loadScenario(std::string(SCENARIOS) + "/" + name + ".yaml"));
    for (int i = 0; i < 1000; ++i) run.step();
    EXPECT_GE(run.detections.size(), 2u) << name;
    for (const auto& [radar, marks] : run.marks) EXPECT_GT(marks.back().running_count, 5u) << name << ", " << radar;
  }
}

/// The most power that so many neighbouring bins hold [m²].
double strongestWindow(const std::vector<float>& amplitude, std::size_t bins) {
  double power = 0.0, strongest = 0.0;
  const auto square = [&](std::size_t i) {
    return static_cast<double>(amplitude[i]) * static_cast<double>(amplitude[i]);
  };
  for (std::size_t i = 0; i < amplitude.size(); ++i) {
    power += square(i) - (i >= bins ? square(i - bins) : 0.0);
    strongest = std::max(strongest, power);
  }
  return strongest;
}

// Without a command the gate stays: the target must be in it long enough to be locked on.
TEST(ShippedScenarios, RangeRadarsOpenTheirGateOnTheirTarget) {
  struct Case {
    std::string name;
    double rcs;          // of the target [m²]
    std::size_t window;  // about its length, in bins
  };
  for (const Case& c : {Case{"full", 3.0, 12}, Case{"mrs_aircraft", 3.0, 24},
                        Case{"mrs_aircraft_no_background", 3.0, 24}, Case{"mrs_ship", 5000.0, 100}}) {
    SimulatedRun run(loadScenario(std::string(SCENARIOS) + "/" + c.name + ".yaml"));
    while (run.profiles["mrs"].size() < 50) run.step();
    double power = 0.0;
    for (const tws_msgs::RangeProfile& profile : run.profiles["mrs"])
      power += strongestWindow(profile.amplitude, c.window) / 50.0;
    EXPECT_GT(power, 0.3 * c.rcs) << c.name;
    EXPECT_LT(power, 3.0 * c.rcs) << c.name;
  }
}

// The report's reason for two radars: they fade at different times. Cover is a chance of 0.8 on one scan. Without cover
// over most of the picture, or with radars that fade together, the trackers' completeness would say nothing.
TEST(ShippedScenarios, AditNominalCoversMostAircraftByOneRadarOrTheOther) {
  SimulatedRun run(loadScenario(std::string(SCENARIOS) + "/adit_nominal.yaml"));
  run.toEnd();
  double all = 0.0, first = 0.0, second = 0.0, either = 0.0;
  for (const tws_msgs::Truth& truth : run.truths()) {
    for (const tws_msgs::TruthTarget& target : truth.targets) {
      if (target.kind != tws_msgs::TruthTarget::AIRCRAFT) continue;
      const bool by_first = target.detection_probability[0] >= 0.8;
      const bool by_second = target.detection_probability[1] >= 0.8;
      all += 1.0;
      first += by_first;
      second += by_second;
      either += by_first || by_second;
    }
  }
  EXPECT_EQ(all, 60.0 * 601.0);
  EXPECT_GE(either / all, 0.8);
  EXPECT_LE(either / all, 0.99);  // and there are places to lose an aircraft in
  EXPECT_GE((either - first) / all, 0.03);
  EXPECT_GE((either - second) / all, 0.03);
}

TEST(RadarPresets, ExistForEachTypeAndNoOther) {
  for (const std::string& type : radarTypes()) EXPECT_GT(radarPreset(type).rotation_period, 0.0);
  EXPECT_EQ(radarPreset("SPS-12").rotation_period, 6.0);
  EXPECT_EQ(radarPreset("SPS-39").rotation_period, 8.0);
  EXPECT_EQ(radarPreset("SPS-39").beams.size(), 2u);
  EXPECT_THROW(radarPreset("SPS-99"), std::invalid_argument);
}

}  // namespace
}  // namespace radar_sim
