#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

#include <tws_core/angles.h>
#include <tws_core/rotation.h>

namespace {

// 48 minutes of a radar with a period of 4 s.
void RotationFromPlots(benchmark::State& state) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> time(0.0, 2880.0);
  std::normal_distribution<double> noise(0.0, 0.005);
  std::vector<tws::TimedAzimuth> plots(static_cast<std::size_t>(state.range(0)));
  for (tws::TimedAzimuth& plot : plots) {
    plot.time = time(generator);
    plot.azimuth = tws::wrapTwoPi(tws::kTwoPi * plot.time / 4.0 + noise(generator));
  }
  for (auto _ : state) benchmark::DoNotOptimize(tws::Rotation::fromPlots(plots));
}
BENCHMARK(RotationFromPlots)->Arg(3000)->Arg(30000)->Unit(benchmark::kMillisecond);

}  // namespace
