// Time of a turn in which one sector holds a flood of plots, and of the two turns after it, in which what they started
// is followed. The work is linear in the plots where an item takes about as long for few and for many.
#include <benchmark/benchmark.h>

#include <random>

#include "window_test_helpers.h"
#include "window_tracker.h"

namespace range_gate_tracker {
namespace {

/// Ten turns with seven targets; in one sector, and one only, so many plots besides.
std::vector<tws::RadarSector> flooded(long plots, double farthest) {
  std::vector<Flight> flights;
  for (int i = 0; i < 7; ++i) flights.push_back(straight(20e3 + 15e3 * i, 30e3, -100.0, 50.0));
  std::vector<tws::RadarSector> sectors = TestRadar::sectors(flights, 10);
  tws::RadarSector& flood = sectors[7 * tws::kSectors + 10];
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> place(0.0, 1.0);
  for (long i = 0; i < plots; ++i) {
    tws::Plot plot;
    plot.time = flood.enter_time + place(random) * (flood.leave_time - flood.enter_time);
    plot.range = 1e3 + place(random) * farthest;
    plot.azimuth = (10.0 + place(random)) * tws::kSectorWidth;
    flood.plots.push_back(plot);
  }
  return sectors;
}

void flood(benchmark::State& state, double farthest) {
  const std::vector<tws::RadarSector> sectors = flooded(state.range(0), farthest);
  for (auto _ : state) {
    WindowTracker tracker({}, [](const WindowReport& report) { benchmark::DoNotOptimize(report.updates.size()); });
    for (const tws::RadarSector& sector : sectors) tracker.process(sector);
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK_CAPTURE(flood, all_ranges, 2e5)->Arg(200)->Arg(2000)->Arg(20003)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(flood, one_place, 1e2)->Arg(200)->Arg(2000)->Arg(20003)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace range_gate_tracker
