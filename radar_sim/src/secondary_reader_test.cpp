#include "secondary_reader.h"

#include <gtest/gtest.h>

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
  EXPECT_EQ(ssr.range_bias, -20.0);
  EXPECT_DOUBLE_EQ(ssr.azimuth_bias, tws::radians(0.1));
  EXPECT_EQ(paramsOf(2).rotation_period, 4.0);
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
