#include "simulation.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/units.h>

#include "radar_presets.h"

namespace radar_sim {
namespace {

Scenario traffic() {
  Scenario scenario;
  scenario.seed = 4;
  scenario.duration = 60.0;
  scenario.origin = {tws::radians(54.0), tws::radians(7.0), 0.0};
  scenario.sites = {{"ship", {0.0, 0.0}}};
  for (const auto& [name, type] : {std::pair("sps12", "SPS-12"), std::pair("sps39", "SPS-39")}) {
    RadarParams radar = radarPreset(type);
    radar.name = name;
    radar.site = "ship";
    scenario.radars.push_back(radar);
  }
  RandomGroup group;
  group.name = "traffic";
  group.count = 20;
  scenario.groups.push_back(group);
  return scenario;
}

struct Record {
  std::vector<SectorReport> sectors;
  std::vector<SecondarySectorReport> secondary;
  std::vector<TruthReport> truths;
  std::vector<double> times;
};

Record run(const Scenario& scenario) {
  Simulation simulation(scenario);
  Record record;
  while (const auto time = simulation.nextTime()) {
    record.times.push_back(*time);
    auto report = simulation.step();
    if (auto* sector = std::get_if<SectorReport>(&report)) {
      EXPECT_EQ(sector->sector.leave_time, *time);
      record.sectors.push_back(*sector);
    } else if (auto* secondary = std::get_if<SecondarySectorReport>(&report)) {
      EXPECT_EQ(secondary->sector.span.leave_time, *time);
      record.secondary.push_back(*secondary);
    } else {
      EXPECT_EQ(std::get<TruthReport>(report).time, *time);
      record.truths.push_back(std::get<TruthReport>(report));
    }
  }
  return record;
}

void expectSamePlots(const Record& a, const Record& b, std::size_t radar) {
  const auto plotsOf = [radar](const Record& record) {
    std::vector<tws::Plot> plots;
    for (const SectorReport& report : record.sectors) {
      if (report.radar == radar) plots.insert(plots.end(), report.sector.plots.begin(), report.sector.plots.end());
    }
    return plots;
  };
  const auto first = plotsOf(a);
  const auto second = plotsOf(b);
  ASSERT_EQ(first.size(), second.size());
  ASSERT_GT(first.size(), 100u);
  for (std::size_t i = 0; i < first.size(); ++i) {
    EXPECT_EQ(first[i].time, second[i].time);
    EXPECT_EQ(first[i].range, second[i].range);
    EXPECT_EQ(first[i].azimuth, second[i].azimuth);
    EXPECT_EQ(first[i].snr, second[i].snr);
  }
}

TEST(Simulation, ReportsInOrderOfTimeUpToItsEnd) {
  const Record record = run(traffic());
  for (std::size_t i = 1; i < record.times.size(); ++i) EXPECT_GE(record.times[i], record.times[i - 1]);
  EXPECT_EQ(record.truths.size(), 61u);
  EXPECT_EQ(record.sectors.size(), 640u + 480u);  // ten turns of 6 s, seven and a half of 8 s
  EXPECT_EQ(record.times.back(), 1060.0);
}

TEST(Simulation, CountsPlotsAndTellsWhereTheOtherBeamPoints) {
  std::vector<std::uint64_t> counts(2, 0);
  for (const SectorReport& report : run(traffic()).sectors) {
    counts[report.radar] += report.sector.plots.size();
    EXPECT_EQ(report.plot_count, counts[report.radar]);
    ASSERT_EQ(report.others.size(), 1u);
    EXPECT_EQ(report.others[0].radar, 1 - report.radar);
    const double period = report.radar == 0 ? 8.0 : 6.0;
    const double turn = std::fmod(report.sector.leave_time - 1000.0, period) / period;
    EXPECT_NEAR(std::remainder(report.others[0].azimuth - 2.0 * M_PI * turn, 2.0 * M_PI), 0.0, 1e-9);
  }
}

TEST(Simulation, RepeatsItselfBitForBit) {
  const Record a = run(traffic());
  const Record b = run(traffic());
  expectSamePlots(a, b, 0);
  expectSamePlots(a, b, 1);
  EXPECT_EQ(a.times, b.times);
}

TEST(Simulation, DiffersFromSeedToSeed) {
  Scenario other = traffic();
  other.seed = 5;
  EXPECT_NE(run(traffic()).sectors.back().plot_count, run(other).sectors.back().plot_count);
}

// A study that adds a radar must not change what the first ones saw.
TEST(Simulation, GivesARadarTheSamePlotsWhenAnotherIsAdded) {
  Scenario more = traffic();
  RadarParams third = radarPreset("SPS-10");
  third.name = "sps10";
  third.site = "ship";
  more.radars.insert(more.radars.begin(), third);
  const Record with = run(more);
  Record renumbered = with;
  for (SectorReport& report : renumbered.sectors) report.radar = (report.radar + 2) % 3;  // the new one last
  const Record without = run(traffic());
  expectSamePlots(without, renumbered, 0);
  expectSamePlots(without, renumbered, 1);
}

Scenario withSecondary(Scenario scenario) {
  SecondaryParams ssr;
  ssr.name = "ssr";
  ssr.site = "ship";
  scenario.secondary_radars.push_back(ssr);
  scenario.groups[0].transponders = {1.0, 0.25};
  return scenario;
}

// As above, and the marks must not change either: a tracker would see another run.
TEST(Simulation, GivesPrimaryRadarsTheSamePlotsMarksAndTruthWhenASecondaryOneIsAdded) {
  const Record without = run(traffic());
  const Record with = run(withSecondary(traffic()));
  expectSamePlots(without, with, 0);
  expectSamePlots(without, with, 1);
  ASSERT_EQ(with.sectors.size(), without.sectors.size());
  for (std::size_t i = 0; i < with.sectors.size(); ++i) {
    EXPECT_EQ(with.sectors[i].sector.leave_time, without.sectors[i].sector.leave_time);
    EXPECT_EQ(with.sectors[i].plot_count, without.sectors[i].plot_count);
    ASSERT_EQ(with.sectors[i].others.size(), 1u);
    EXPECT_EQ(with.sectors[i].others[0].azimuth, without.sectors[i].others[0].azimuth);
  }
  ASSERT_EQ(with.truths.size(), without.truths.size());
  EXPECT_EQ(with.truths.back().entries.back().state.position, without.truths.back().entries.back().state.position);
  EXPECT_EQ(with.truths.back().entries.back().sightings.size(), 2u);
}

TEST(Simulation, ReportsASecondaryRadarSectorBySectorAfterThePrimaryOfItsMast) {
  const Record record = run(withSecondary(traffic()));
  EXPECT_EQ(record.secondary.size(), 640u);
  EXPECT_GT(record.secondary.back().plot_count, 180u);  // 20 aircraft in cover, ten turns
  for (const SecondarySectorReport& report : record.secondary) EXPECT_EQ(report.others.size(), 2u);
  Simulation simulation(withSecondary(traffic()));
  int primary = 0, secondary = 0;
  while (simulation.nextTime()) {
    const auto report = simulation.step();
    const auto* sector = std::get_if<SectorReport>(&report);
    primary += sector != nullptr && sector->radar == 0;
    secondary += std::holds_alternative<SecondarySectorReport>(report);
    EXPECT_LE(secondary, primary);
    EXPECT_LE(primary, secondary + 1);
  }
}

// The feed stops and resumes: the consumers' case of a broken line.
TEST(Simulation, SilencesASecondaryRadarAloneDuringItsOutage) {
  Scenario scenario = withSecondary(traffic());
  Fault outage;
  outage.radar = "ssr";
  outage.from = 1012.0;
  outage.to = 1030.0;
  scenario.faults.push_back(outage);
  const Record record = run(scenario);
  EXPECT_EQ(record.secondary.size(), 640u - 192u);
  EXPECT_EQ(record.sectors.size(), 640u + 480u);
  for (const SecondarySectorReport& report : record.secondary)
    EXPECT_TRUE(report.sector.span.leave_time < 1012.0 || report.sector.span.leave_time >= 1030.0);
}

// An outage is silence: no marks, and the other radar is told nothing of this one's antenna.
TEST(Simulation, IsSilentDuringAnOutageWhileTheAntennaTurnsOn) {
  Scenario scenario = traffic();
  Fault outage;
  outage.radar = "sps12";
  outage.from = 1012.0;
  outage.to = 1030.0;
  scenario.faults.push_back(outage);
  std::int64_t before = 0;
  std::int64_t after = 0;
  for (const SectorReport& report : run(scenario).sectors) {
    const bool within = report.sector.leave_time >= 1012.0 && report.sector.leave_time < 1030.0;
    if (report.radar == 1) {
      EXPECT_EQ(report.others.size(), within ? 0u : 1u);
      continue;
    }
    EXPECT_FALSE(within) << report.sector.leave_time;
    if (report.sector.leave_time < 1012.0) before = report.sector.running;
    if (after == 0 && report.sector.leave_time >= 1030.0) after = report.sector.running;
  }
  EXPECT_EQ(before, 126);        // the mark at 1012 s, which would close sector 127, is not heard
  EXPECT_EQ(after, 64 * 5 - 1);  // the mark at 1030 s closes the fifth turn
}

// Truth decides what counts as "in cover".
TEST(Simulation, TruthStatesWhatEachRadarWouldMeasure) {
  const Record record = run(traffic());
  for (const TruthReport& truth : record.truths) {
    EXPECT_EQ(truth.entries.size(), 20u);
    for (const TruthReport::Entry& entry : truth.entries) {
      ASSERT_EQ(entry.sightings.size(), 2u);
      const Eigen::Vector3d& p = entry.state.position;
      EXPECT_NEAR(entry.sightings[0].slant_range, std::sqrt(p.x() * p.x() + p.y() * p.y() + std::pow(p.z() - 25.0, 2)),
                  1e-3);
      EXPECT_NEAR(std::remainder(entry.sightings[0].azimuth - std::atan2(p.x(), p.y()), 2.0 * M_PI), 0.0, 1e-9);
      for (const auto& sighting : entry.sightings) {
        EXPECT_GE(sighting.detection_probability, 0.0);
        EXPECT_LE(sighting.detection_probability, 1.0);
      }
    }
  }
}

// Two sites 20 km apart: the tf frames and the polar truth must tell the same place.
TEST(Simulation, SeesEachTargetFromItsOwnSite) {
  Scenario scenario = traffic();
  scenario.sites.push_back({"island", {20e3, 0.0}});
  scenario.radars[1].site = "island";
  const Eigen::Isometry3d map_to_island = mapToRadar(scenario, scenario.radars[1]);
  EXPECT_NEAR((map_to_island.inverse() * Eigen::Vector3d::Zero()).head<2>().x(), 20e3, 0.5);
  // North at the island is turned by longitude · sin(latitude): 20 km / (cos 54° · 6391 km) · sin 54° = 0.247°.
  const Eigen::Vector3d north_in_map = map_to_island.linear().transpose() * Eigen::Vector3d::UnitY();
  EXPECT_NEAR(tws::degrees(std::atan2(north_in_map.x(), north_in_map.y())), -0.247, 0.003);
  const Record record = run(scenario);
  for (const auto& entry : record.truths.front().entries) {
    const Eigen::Vector3d at_island = map_to_island * entry.state.position;
    EXPECT_NEAR(entry.sightings[1].slant_range, at_island.norm(), 1e-6);
  }
}

TEST(Simulation, RefusesANameThatIsUsedTwice) {
  Scenario scenario = traffic();
  scenario.groups.push_back(scenario.groups.front());
  EXPECT_THROW(Simulation{scenario}, std::invalid_argument);
}

TEST(Simulation, RunsWithoutRadars) {
  Scenario scenario = traffic();
  scenario.radars.clear();
  EXPECT_EQ(run(scenario).truths.size(), 61u);
}

}  // namespace
}  // namespace radar_sim
