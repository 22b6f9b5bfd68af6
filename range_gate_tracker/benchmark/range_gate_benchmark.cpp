// Range bins a second of one core, from the amplitudes to the measured range.
#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "detection_window.h"

namespace range_gate_tracker {
namespace {

void measureRange(benchmark::State& state, Background background) {
  RangeProfile profile;
  std::mt19937_64 random(1);
  std::exponential_distribution<float> noise_power;
  for (long bin = 0; bin < state.range(0); ++bin) profile.amplitude.push_back(std::sqrt(noise_power(random)));
  DetectionWindow window(24, background);
  for (auto _ : state) benchmark::DoNotOptimize(window.search(profile));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK_CAPTURE(measureRange, none, Background::kNone)->Arg(256)->Arg(1024)->Arg(8192);
BENCHMARK_CAPTURE(measureRange, local, Background::kLocal)->Arg(256)->Arg(1024)->Arg(8192);
BENCHMARK_CAPTURE(measureRange, global, Background::kGlobal)->Arg(256)->Arg(1024)->Arg(8192);

}  // namespace
}  // namespace range_gate_tracker

BENCHMARK_MAIN();
