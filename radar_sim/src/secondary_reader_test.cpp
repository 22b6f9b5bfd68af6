#include "secondary_reader.h"

#include <gtest/gtest.h>

#include "rotating_sensor.h"
#include "scenario_file_test_helpers.h"
#include "secondary_sensor.h"

namespace radar_sim {
namespace {

TEST_F(ScenarioFile, ReadsASecondaryRadarOnAPrimarysMast) {
  const Scenario scenario = load(R"(
radars:
  - {name: sps12, type: SPS-12, start_azimuth_deg: 90, antenna_height_m: 33, time_lsb_s: 0.004}
secondary_radars:
  - name: ssr
    on_mast_of: sps12
    azimuth_beamwidth_deg: 3
    interrogation_rate_hz: 250
    interlace: [3A, C, 2]
    missed_reply_probability: 0.1
    needed_replies: 5
    needed_code_replies: 3
    fruit_plots_per_scan: 7
    range_bias_m: -20
    azimuth_bias_deg: 0.1
  - {name: iff, rotation_period_s: 4}
)");
  ASSERT_EQ(scenario.sensors.size(), 3u);
  const auto paramsOf = [&](std::size_t i) { return dynamic_cast<const SecondarySpec&>(*scenario.sensors[i]).params; };
  const SecondaryParams ssr = paramsOf(1);
  EXPECT_EQ(ssr.site, "origin");
  EXPECT_EQ(ssr.rotation_period, 6.0);
  EXPECT_DOUBLE_EQ(ssr.start_azimuth, tws::radians(90.0));
  EXPECT_EQ(ssr.antenna_height, 33.0);
  EXPECT_EQ(ssr.time_lsb, 0.004);
  EXPECT_DOUBLE_EQ(ssr.azimuth_beamwidth, tws::radians(3.0));
  EXPECT_EQ(ssr.interrogation_rate, 250.0);
  EXPECT_EQ(ssr.interlace, (std::vector<Mode>{Mode::k3A, Mode::kC, Mode::k2}));
  EXPECT_EQ(ssr.missed_reply_probability, 0.1);
  EXPECT_EQ(ssr.needed_replies, 5);
  EXPECT_EQ(ssr.needed_code_replies, 3);
  EXPECT_EQ(ssr.fruit_plots_per_scan, 7.0);
  EXPECT_EQ(ssr.errors.range_bias, -20.0);
  EXPECT_DOUBLE_EQ(ssr.beam_offset, tws::radians(0.1));
  EXPECT_EQ(paramsOf(2).rotation_period, 4.0);
}

TEST_F(ScenarioFile, ReadsTheErrorsOfRegistration) {
  const Scenario scenario = load(R"(
radars:
  - name: a
    range_bias_m: 50
    range_gain: -0.0002
    air_delay: true
    azimuth_bias_deg: -0.4
    eccentricity_deg: 0.2
    eccentricity_phase_deg: 60
    north_drift_deg_h: 3.6
    tilt_deg: 0.5
    tilt_azimuth_deg: 120
    clock_offset_s: -0.05
    clock_drift_ppm: 20
secondary_radars:
  - {name: on, on_mast_of: a, range_gain: 0.001, azimuth_bias_deg: 0.1}
  - {name: own, azimuth_bias_deg: 0.1, clock_offset_s: 2}
)");
  const RegistrationErrors a = dynamic_cast<const RotatingSpec&>(*scenario.sensors[0]).params.errors;
  EXPECT_EQ(a.range_bias, 50.0);
  EXPECT_EQ(a.range_gain, -0.0002);
  EXPECT_TRUE(a.air_delays);
  EXPECT_DOUBLE_EQ(a.azimuth.bias, tws::radians(-0.4));
  EXPECT_DOUBLE_EQ(a.azimuth.eccentricity, tws::radians(0.2));
  EXPECT_DOUBLE_EQ(a.azimuth.eccentricity_phase, tws::radians(60.0));
  EXPECT_NEAR(a.azimuth.north_drift, tws::radians(0.001), 1e-15);  // a second
  EXPECT_DOUBLE_EQ(a.tilt, tws::radians(0.5));
  EXPECT_DOUBLE_EQ(a.tilt_azimuth, tws::radians(120.0));
  EXPECT_EQ(a.clock.offset, -0.05);
  EXPECT_DOUBLE_EQ(a.clock.drift, 20e-6);
  const SecondaryParams on = dynamic_cast<const SecondarySpec&>(*scenario.sensors[1]).params;
  EXPECT_EQ(on.errors.azimuth.bias, a.azimuth.bias);
  EXPECT_EQ(on.errors.clock.offset, a.clock.offset);
  EXPECT_EQ(on.errors.tilt, a.tilt);
  EXPECT_EQ(on.errors.range_bias, 0.0);
  EXPECT_EQ(on.errors.range_gain, 0.001);
  EXPECT_DOUBLE_EQ(on.beam_offset, tws::radians(0.1));
  const SecondaryParams own = dynamic_cast<const SecondarySpec&>(*scenario.sensors[2]).params;
  EXPECT_DOUBLE_EQ(own.errors.azimuth.bias, tws::radians(0.1));
  EXPECT_EQ(own.beam_offset, 0.0);
  EXPECT_EQ(own.errors.clock.offset, 2.0);
}

TEST_F(ScenarioFile, IsRefusedForWrongErrorsOfRegistration) {
  const std::string radar = "radars:\n  - name: a\n";
  expectComplaint(radar + "    range_gain: 0.5\n", 3, "is not in [-0.1, 0.1]");
  expectComplaint(radar + "    eccentricity_deg: -1\n", 3, "is not in [0, 5]");
  expectComplaint(radar + "    north_drift_deg_h: 400\n", 3, "is not in [-360, 360]");
  expectComplaint(radar + "    tilt_deg: 6\n", 3, "is not in [0, 5]");
  expectComplaint(radar + "    clock_offset_s: 61\n", 3, "is not in [-60, 60]");
  expectComplaint(radar + "    clock_drift_ppm: .nan\n", 3, "expected a number");
  expectComplaint(radar + "    air_delay: 3\n", 3, "air_delay");
  expectComplaint("start_time_s: 5\n" + radar + "    clock_offset_s: -6\n", 4, "below 0 at the scenario's start");
  expectComplaint(radar + "secondary_radars:\n  - name: s\n    on_mast_of: a\n    tilt_deg: 1\n", 6,
                  "one of them only");
}

TEST_F(ScenarioFile, GivesAircraftTheirCodesOrDrawsThem) {
  const std::string place = ", east_m: 0, north_m: 50000";
  const auto targets = allTargets(load("targets:\n  - {name: a" + place +
                                       ", transponder: {mode_1: 31, mode_2: 0017, mode_3a: 0421, mode_c: false, "
                                       "silent: [{from_s: 10, to_s: 20}]}}\n  - {name: b" +
                                       place + "}\n  - {name: c, kind: ship" + place +
                                       "}\nrandom_aircraft:\n  - {count: 3, transponder: {military_fraction: 1}}\n"));
  const Transponder& a = targets.at(0).transponder;
  EXPECT_EQ(a.codes, (std::array<int, 3>{03100, 00017, 00421}));
  EXPECT_FALSE(a.altitude);
  EXPECT_TRUE(a.isSilentAt(1015.0));
  const Transponder& b = targets.at(1).transponder;
  EXPECT_GE(b.codes[index(Mode::k3A)], 1);
  EXPECT_EQ(b.codes[index(Mode::k1)], Transponder::kNone);
  EXPECT_TRUE(b.altitude);
  EXPECT_FALSE(targets.at(2).transponder.altitude);
  EXPECT_EQ(targets.at(2).transponder.codes[index(Mode::k3A)], Transponder::kNone);
  EXPECT_GE(targets.at(3).transponder.codes[index(Mode::k1)], 0);
}

TEST_F(ScenarioFile, IsRefusedForAWrongSecondaryRadar) {
  const std::string ssr = "radars: [{name: a}]\nsecondary_radars:\n  - name: s\n";
  expectComplaint("secondary_radars:\n  - {rotation_period_s: 6}\n", 2, "name: is required");
  expectComplaint("radars: [{name: a}]\nsecondary_radars: [{name: a}]\n", 2, "used twice");
  expectComplaint(ssr + "    on_mast_of: b\n", 4, "'b' is not one of a");
  expectComplaint(ssr + "    on_mast_of: a\n    rotation_period_s: 6\n", 5, "one of them only");
  expectComplaint(ssr + "    site: moon\n", 4, "there is no site 'moon'");
  expectComplaint(ssr + "    interlace: []\n", 4, "empty");
  expectComplaint(ssr + "    interlace: [3A, S]\n", 4, "'S' is not one of 1, 2, 3A, C");
  expectComplaint(ssr + "    missed_reply_probability: 1.5\n", 4, "is not in [0, 1]");
  expectComplaint(ssr + "    missed_reply_probability: .nan\n", 4, "expected a number");
  expectComplaint(ssr + "    needed_replies: 20\n", 4, "the beam is on an aircraft for 14.4");
  expectComplaint(ssr + "    max_range_m: 500000\n", 4, "416378");  // c / 2 / 360 Hz
  expectComplaint(ssr + "    max_range_m: 500\n", 4, "is not greater than min_range_m");
  expectComplaint(ssr + "    range_sigma_m: -1\n", 4, "range_sigma_m: -1 is not in");
  expectComplaint(ssr + "    false_alarms_per_scan: 3\n", 4, "not a known key");
  expectComplaint(ssr +
                      "faults:\n  - {type: false_alarm_burst, radar: s, from_s: 1, to_s: 2, "
                      "false_alarms_per_scan: 3}\n",
                  5, "'s' is not one of a");
  EXPECT_EQ(load(ssr + "faults:\n  - {type: outage, radar: s, from_s: 1, to_s: 2}\n").faults.at(0).radar, "s");
}

TEST_F(ScenarioFile, IsRefusedForAWrongTransponder) {
  const std::string target = "targets:\n  - name: a\n    east_m: 5\n    north_m: 5\n    transponder:\n";
  expectComplaint(target + "      mode_3a: 0181\n", 6, "'0181' is neither 4 octal digits nor 'drawn' nor 'none'");
  expectComplaint(target + "      mode_3a: 421\n", 6, "4 octal digits");
  expectComplaint(target + "      mode_2: 12345\n", 6, "4 octal digits");
  expectComplaint(target + "      mode_1: 34\n", 6, "the second digit of '34' is not in 0 .. 3");
  expectComplaint(target + "      mode_c: 3000\n", 6, "mode_c");
  expectComplaint(target + "      silent: [{from_s: 5, to_s: 5}]\n", 6, "is not later than from_s");
  expectComplaint(target + "      squawk: 1234\n", 6, "not a known key");
  expectComplaint("random_aircraft:\n  - count: 2\n    transponder: {fraction: 2}\n", 3, "is not in [0, 1]");
  expectComplaint("clutter:\n  - name: a\n    transponder: {mode_3a: 1234}\n    east_m: 5\n    north_m: 5\n", 3,
                  "not a known key");
}

}  // namespace
}  // namespace radar_sim
