#include "simulation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iomanip>
#include <sstream>
#include <tuple>

#include <tws_core/units.h>

#include "radar_presets.h"
#include "rotating_sensor.h"
#include "secondary_sensor.h"
#include "simulated_run_test_helpers.h"

namespace radar_sim {
namespace {

RadarParams radarOf(const std::string& name, const std::string& type) {
  RadarParams radar = radarPreset(type);
  radar.name = name;
  radar.site = "ship";
  return radar;
}

Scenario traffic() {
  Scenario scenario;
  scenario.seed = 4;
  scenario.duration = 60.0;
  scenario.origin = {tws::radians(54.0), tws::radians(7.0), 0.0};
  scenario.sites = {{"ship", {0.0, 0.0}}};
  scenario.sensors.push_back(std::make_shared<RotatingSpec>(radarOf("sps12", "SPS-12")));
  scenario.sensors.push_back(std::make_shared<RotatingSpec>(radarOf("sps39", "SPS-39")));
  RandomGroup group;
  group.name = "traffic";
  group.count = 20;
  scenario.groups.push_back(group);
  return scenario;
}

SimulatedRun& completed(SimulatedRun& run) {
  run.toEnd();
  return run;
}

/// Messages as text, which says NaN for NaN.
template <class M>
std::string textOf(const std::vector<M>& messages) {
  std::ostringstream text;
  text << std::setprecision(17);
  for (const M& message : messages) text << message;
  return text.str();
}

std::size_t plotsIn(const std::vector<tws_msgs::Detections>& messages) {
  std::size_t plots = 0;
  for (const tws_msgs::Detections& message : messages) plots += message.detections.size();
  return plots;
}

void expectSamePlots(SimulatedRun& a, SimulatedRun& b) {
  for (const char* radar : {"sps12", "sps39"}) {
    EXPECT_GT(plotsIn(a.detections[radar]), 100u);
    EXPECT_EQ(textOf(a.detections[radar]), textOf(b.detections[radar])) << radar;
  }
}

TEST(Simulation, ReportsInOrderOfTimeUpToItsEnd) {
  SimulatedRun run(traffic());
  run.toEnd();
  for (std::size_t i = 1; i < run.times.size(); ++i) EXPECT_GE(run.times[i], run.times[i - 1]);
  EXPECT_EQ(run.truths().size(), 61u);
  EXPECT_EQ(run.marks["sps12"].size(), 640u);  // ten turns of 6 s
  EXPECT_EQ(run.marks["sps39"].size(), 480u);  // seven and a half of 8 s
  EXPECT_EQ(run.marks["sps12"].back().header.stamp, ros::Time(1060));
}

// Who relies on the order: a tracker that hears truth, and both radars of one mast, at one time.
TEST(Simulation, ReportsTruthFirstThenTheSensorsInTheirOrder) {
  SimulatedRun run(traffic());
  while (*run.simulation.nextTime() < 1024.0) run.step();
  run.topics.clear();
  while (*run.simulation.nextTime() == 1024.0) run.step();  // three turns of sps39, four of sps12
  EXPECT_EQ(run.topics, (std::vector<std::string>{"truth", "sps12/detections", "sps12/sector_marks", "sps39/detections",
                                                  "sps39/sector_marks"}));
}

TEST(Simulation, CountsPlotsAndTellsWhereTheOtherBeamPoints) {
  SimulatedRun run(traffic());
  run.toEnd();
  for (const auto& [radar, other, period] : {std::tuple("sps12", "sps39", 8.0), std::tuple("sps39", "sps12", 6.0)}) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < run.marks[radar].size(); ++i) {
      const tws_msgs::SectorMark& mark = run.marks[radar][i];
      count += run.detections[radar][i].detections.size();
      EXPECT_EQ(mark.running_count, count);
      ASSERT_EQ(mark.other_radars, std::vector<std::string>{other});
      const double turn = std::fmod(mark.header.stamp.toSec() - 1000.0, period) / period;
      EXPECT_NEAR(std::remainder(mark.other_azimuths[0] - 2.0 * M_PI * turn, 2.0 * M_PI), 0.0, 1e-6);
    }
  }
}

TEST(Simulation, RepeatsItselfBitForBit) {
  SimulatedRun a(traffic()), b(traffic());
  expectSamePlots(completed(a), completed(b));
  EXPECT_EQ(a.times, b.times);
}

TEST(Simulation, DiffersFromSeedToSeed) {
  Scenario other_seed = traffic();
  other_seed.seed = 5;
  SimulatedRun run(traffic()), other(other_seed);
  EXPECT_NE(textOf(completed(run).detections["sps12"]), textOf(completed(other).detections["sps12"]));
}

// A study that adds a radar must not change what the first ones saw.
TEST(Simulation, GivesARadarTheSamePlotsWhenAnotherIsAdded) {
  Scenario more = traffic();
  more.sensors.insert(more.sensors.begin(), std::make_shared<RotatingSpec>(radarOf("sps10", "SPS-10")));
  SimulatedRun without(traffic()), with(more);
  expectSamePlots(completed(without), completed(with));
}

Scenario withSecondary(Scenario scenario) {
  SecondaryParams ssr;
  ssr.name = "ssr";
  ssr.site = "ship";
  scenario.sensors.push_back(std::make_shared<SecondarySpec>(ssr));
  scenario.groups[0].transponders = {1.0, 0.25};
  return scenario;
}

// As above, and the marks must not change either: a tracker would see another run.
TEST(Simulation, GivesPrimaryRadarsTheSamePlotsMarksAndTruthWhenASecondaryOneIsAdded) {
  SimulatedRun without(traffic()), with(withSecondary(traffic()));
  expectSamePlots(completed(without), completed(with));
  EXPECT_EQ(textOf(with.marks["sps12"]), textOf(without.marks["sps12"]));
  EXPECT_EQ(textOf(with.marks["sps39"]), textOf(without.marks["sps39"]));
  ASSERT_EQ(with.truths().size(), without.truths().size());
  EXPECT_EQ(with.truths().back().radars.size(), 2u);
  EXPECT_EQ(with.truths().back().targets.back().position.x, without.truths().back().targets.back().position.x);
}

TEST(Simulation, ReportsASecondaryRadarSectorBySectorAfterThePrimaryOfItsMast) {
  SimulatedRun run(withSecondary(traffic()));
  while (run.simulation.nextTime()) {
    run.step();
    EXPECT_LE(run.marks["ssr"].size(), run.marks["sps12"].size());
    EXPECT_LE(run.marks["sps12"].size(), run.marks["ssr"].size() + 1);
  }
  EXPECT_EQ(run.marks["ssr"].size(), 640u);
  EXPECT_GT(run.marks["ssr"].back().running_count, 180u);  // 20 aircraft in cover, ten turns
  for (const tws_msgs::SectorMark& mark : run.marks["ssr"]) EXPECT_EQ(mark.other_radars.size(), 2u);
}

Scenario withOutage(Scenario scenario, const std::string& radar) {
  Fault outage;
  outage.radar = radar;
  outage.from = 1012.0;
  outage.to = 1030.0;
  scenario.faults.push_back(outage);
  return scenario;
}

bool isWithinOutage(const tws_msgs::SectorMark& mark) {
  return mark.header.stamp >= ros::Time(1012) && mark.header.stamp < ros::Time(1030);
}

// The feed stops and resumes: the consumers' case of a broken line.
TEST(Simulation, SilencesASecondaryRadarAloneDuringItsOutage) {
  SimulatedRun run(withOutage(withSecondary(traffic()), "ssr"));
  run.toEnd();
  EXPECT_EQ(run.marks["ssr"].size(), 640u - 192u);
  EXPECT_EQ(run.marks["sps12"].size(), 640u);
  EXPECT_EQ(run.marks["sps39"].size(), 480u);
  for (const tws_msgs::SectorMark& mark : run.marks["ssr"]) EXPECT_FALSE(isWithinOutage(mark));
}

// An outage is silence: no marks, and the other radar is told nothing of this one's antenna.
TEST(Simulation, IsSilentDuringAnOutageWhileTheAntennaTurnsOn) {
  SimulatedRun run(withOutage(traffic(), "sps12"));
  run.toEnd();
  for (const tws_msgs::SectorMark& mark : run.marks["sps39"])
    EXPECT_EQ(mark.other_radars.size(), isWithinOutage(mark) ? 0u : 1u);
  const auto& marks = run.marks["sps12"];
  EXPECT_TRUE(std::none_of(marks.begin(), marks.end(), isWithinOutage));
  const auto isAfter = [](const tws_msgs::SectorMark& mark) { return mark.header.stamp >= ros::Time(1030); };
  const auto after = std::find_if(marks.begin(), marks.end(), isAfter);
  ASSERT_NE(after, marks.end());
  EXPECT_EQ(std::prev(after)->running_sector, 127u);  // the mark at 1012 s, which would be 128, is not heard
  EXPECT_EQ(after->running_sector, 64u * 5u);         // the mark at 1030 s closes the fifth turn
}

// Truth decides what counts as "in cover".
TEST(Simulation, TruthStatesWhatEachRadarWouldMeasure) {
  SimulatedRun run(traffic());
  run.toEnd();
  for (const tws_msgs::Truth& truth : run.truths()) {
    EXPECT_EQ(truth.radars, (std::vector<std::string>{"sps12", "sps39"}));
    EXPECT_EQ(truth.targets.size(), 20u);
    for (const tws_msgs::TruthTarget& target : truth.targets) {
      ASSERT_EQ(target.slant_range.size(), 2u);
      const auto& p = target.position;
      EXPECT_NEAR(target.slant_range[0], std::sqrt(p.x * p.x + p.y * p.y + std::pow(p.z - 25.0, 2)), 1e-3);
      EXPECT_NEAR(std::remainder(target.azimuth[0] - std::atan2(p.x, p.y), 2.0 * M_PI), 0.0, 1e-9);
      for (const double probability : target.detection_probability) {
        EXPECT_GE(probability, 0.0);
        EXPECT_LE(probability, 1.0);
      }
    }
  }
}

// Two sites 20 km apart: the tf frames and the polar truth must tell the same place.
TEST(Simulation, SeesEachTargetFromItsOwnSite) {
  Scenario scenario = traffic();
  scenario.sites.push_back({"island", {20e3, 0.0}});
  RadarParams island = radarOf("sps39", "SPS-39");
  island.site = "island";
  scenario.sensors[1] = std::make_shared<RotatingSpec>(island);
  const Eigen::Isometry3d map_to_island = mapToAntenna(scenario, "sps39", "island", island.antenna_height);
  EXPECT_NEAR((map_to_island.inverse() * Eigen::Vector3d::Zero()).head<2>().x(), 20e3, 0.5);
  // North at the island is turned by longitude · sin(latitude): 20 km / (cos 54° · 6391 km) · sin 54° = 0.247°.
  const Eigen::Vector3d north_in_map = map_to_island.linear().transpose() * Eigen::Vector3d::UnitY();
  EXPECT_NEAR(tws::degrees(std::atan2(north_in_map.x(), north_in_map.y())), -0.247, 0.003);
  SimulatedRun run(scenario);
  run.step();
  ASSERT_EQ(run.truths().size(), 1u);
  for (const tws_msgs::TruthTarget& target : run.truths().front().targets) {
    const Eigen::Vector3d position(target.position.x, target.position.y, target.position.z);
    EXPECT_NEAR(target.slant_range[1], (map_to_island * position).norm(), 1e-6);
  }
}

TEST(Simulation, RefusesASiteThatIsNotThere) {
  Scenario scenario = traffic();
  scenario.sites.front().name = "harbour";
  EXPECT_THROW(Simulation{scenario}, std::invalid_argument);
}

TEST(Simulation, RefusesANameThatIsUsedTwice) {
  Scenario scenario = traffic();
  scenario.groups.push_back(scenario.groups.front());
  EXPECT_THROW(Simulation{scenario}, std::invalid_argument);
}

TEST(Simulation, RunsWithoutRadars) {
  Scenario scenario = traffic();
  scenario.sensors.clear();
  SimulatedRun run(scenario);
  run.toEnd();
  EXPECT_EQ(run.truths().size(), 61u);
}

}  // namespace
}  // namespace radar_sim
