#include <benchmark/benchmark.h>

#include <iostream>
#include <string>
#include <utility>

#include <tws_core/units.h>
#include <tws_msgs/Detections.h>
#include <tws_runtime/local_graph.h>

#include "radar_presets.h"
#include "rotating_sensor.h"
#include "sensor_port.h"
#include "simulation.h"

namespace {

using namespace radar_sim;

Scenario traffic(long aircraft) {
  Scenario scenario;
  scenario.duration = 1e6;
  scenario.truth_period = 1.0;
  scenario.sites = {{"ship", {0.0, 0.0}}};
  for (const auto& [name, type] : {std::pair("sps12", "SPS-12"), std::pair("sps39", "SPS-39")}) {
    RadarParams radar = radarPreset(type);
    radar.name = name;
    radar.site = "ship";
    scenario.sensors.push_back(std::make_shared<RotatingSpec>(radar));
  }
  RandomGroup group;
  group.name = "aircraft";
  group.count = aircraft;
  group.turning_fraction = 0.5;
  group.turn_rate = {tws::radians(1.0), tws::radians(3.0)};
  scenario.groups.push_back(group);
  return scenario;
}

/// A minute of two radars on a bus that nobody else is on, truth once a second included.
void simulateMinute(benchmark::State& state) {
  Simulation simulation(traffic(state.range(0)));
  tws_runtime::LocalGraph graph(std::cerr);
  std::uint64_t plots = 0;
  tws_runtime::Bus& counter = graph.addNode("counter");
  for (const char* radar : {"sps12", "sps39"})
    counter.subscribe<tws_msgs::Detections>(
        std::string("/") + radar + "/detections",
        [&plots](const tws_msgs::Detections& message) { plots += message.detections.size(); });
  connect(simulation.sensors(), graph.addNode("radar_sim"));
  double minutes = 0.0;
  double until = *simulation.nextTime();
  for (auto _ : state) {
    until += 60.0;
    minutes += 1.0;
    for (; *simulation.nextTime() < until; graph.drain()) simulation.step();
  }
  state.counters["plots"] = benchmark::Counter(static_cast<double>(plots), benchmark::Counter::kIsRate);
  state.counters["simulated_s"] = benchmark::Counter(minutes * 60.0, benchmark::Counter::kIsRate);
}
BENCHMARK(simulateMinute)->Arg(60)->Arg(1000)->Arg(10000)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
