// What the frame builder costs: measurements a second, against dwells and measurements in the open frame.
#include <benchmark/benchmark.h>

#include <random>

#include "frame_builder.h"

namespace esa_frame_builder {
namespace {

constexpr double kBeamwidth = 0.03;

/// Dwells of one frame: a raster of beams 0.7 beamwidths apart, so that each overlaps its neighbours, row over row of
/// ten.
std::vector<Dwell> raster(std::size_t dwells, std::size_t measurements) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> offset(-0.5 * kBeamwidth, 0.5 * kBeamwidth), range(50e3, 60e3), snr(20, 500);
  std::vector<Dwell> result(dwells);
  for (std::size_t k = 0; k < dwells; ++k) {
    Dwell& dwell = result[k];
    const std::size_t column = k % 10, row = k / 10;
    dwell.u = 0.7 * kBeamwidth * static_cast<double>(column);
    dwell.v = 0.7 * kBeamwidth * static_cast<double>(row);
    dwell.beamwidth_u = dwell.beamwidth_v = kBeamwidth;
    dwell.range_max = 100e3;
    dwell.measurements.resize(measurements);
    for (Measurement& m : dwell.measurements) {
      m.range = range(generator);
      m.u = dwell.u + offset(generator);
      m.v = dwell.v + offset(generator);
      m.snr = snr(generator);
      m.covariance.diagonal() << 100.0, 1e-6, 1e-6;
    }
  }
  return result;
}

/// Frames of range(0) dwells with range(1) measurements each, one resource period a frame, through algorithm range(2).
/// Items are measurements.
void BM_FrameBuilder(benchmark::State& state) {
  const auto dwells = static_cast<std::size_t>(state.range(0)), measurements = static_cast<std::size_t>(state.range(1));
  FrameBuilderParams params;
  params.algorithm = static_cast<Algorithm>(state.range(2));
  params.max_frame_time = 0.1;
  FrameBuilder builder(params);
  const std::vector<Dwell> frame = raster(dwells, measurements);
  double time = 0.0;
  for (auto _ : state) {
    ResourcePeriod period{0.1, time, frame};
    time += 0.2;
    for (std::size_t k = 0; k < dwells; ++k)
      period.dwells[k].time = time + 0.1 * static_cast<double>(k) / static_cast<double>(dwells);
    benchmark::DoNotOptimize(builder.take(std::move(period)));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(dwells * measurements));
}
BENCHMARK(BM_FrameBuilder)
    ->ArgNames({"dwells", "measurements", "algorithm"})
    ->ArgsProduct({{10}, {10}, {1, 2, 3, 4}})
    ->ArgsProduct({{1, 5, 20, 50, 100}, {10}, {3}})
    ->ArgsProduct({{10}, {1, 100, 1000}, {3}});

}  // namespace
}  // namespace esa_frame_builder

BENCHMARK_MAIN();
