#include <benchmark/benchmark.h>

#include <tws_core/units.h>

#include "radar_presets.h"
#include "simulation.h"

namespace {

using namespace radar_sim;

Scenario traffic(long aircraft) {
  Scenario scenario;
  scenario.duration = 1e6;
  scenario.truth_period = 1.0;
  scenario.sites = {{"ship", {0.0, 0.0}}};
  for (const char* type : {"SPS-12", "SPS-39"}) {
    RadarParams radar = radarPreset(type);
    radar.name = type;
    radar.site = "ship";
    scenario.radars.push_back(radar);
  }
  RandomGroup group;
  group.name = "aircraft";
  group.count = aircraft;
  group.turning_fraction = 0.5;
  group.turn_rate = {tws::radians(1.0), tws::radians(3.0)};
  scenario.groups.push_back(group);
  return scenario;
}

/// A minute of two radars, truth once a second included.
void simulateMinute(benchmark::State& state) {
  Simulation simulation(traffic(state.range(0)));
  std::uint64_t plots = 0;
  double minutes = 0.0;
  double until = *simulation.nextTime();
  for (auto _ : state) {
    until += 60.0;
    minutes += 1.0;
    while (*simulation.nextTime() < until) {
      const auto report = simulation.step();
      if (const auto* sector = std::get_if<SectorReport>(&report)) plots += sector->sector.plots.size();
    }
  }
  state.counters["plots"] = benchmark::Counter(static_cast<double>(plots), benchmark::Counter::kIsRate);
  state.counters["simulated_s"] = benchmark::Counter(minutes * 60.0, benchmark::Counter::kIsRate);
}
BENCHMARK(simulateMinute)->Arg(60)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
