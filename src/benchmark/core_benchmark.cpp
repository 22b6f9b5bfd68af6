#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include <tws_core/axis_filter.h>
#include <tws_core/csv_table.h>
#include <tws_core/geodesy.h>
#include <tws_core/geometry.h>
#include <tws_core/kalman.h>
#include <tws_core/number_file.h>
#include <tws_core/sector_file.h>
#include <tws_core/time_order.h>

namespace {

std::vector<double> randomNumbers(double least, double greatest) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> uniform(least, greatest);
  std::vector<double> numbers(4096);
  for (double& number : numbers) number = uniform(generator);
  return numbers;
}

// Numbers in turn from a fixed random list, so that branches are as unpredictable as in use.
class Cycle {
 public:
  Cycle(double least, double greatest) : numbers_(randomNumbers(least, greatest)) {}
  double next() { return numbers_[at_++ & 4095]; }

 private:
  std::vector<double> numbers_;
  std::size_t at_ = 0;
};

void SectorOf(benchmark::State& state) {
  Cycle azimuths(-7.0, 7.0);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(tws::sectorOf(azimuths.next()));
}
BENCHMARK(SectorOf);

void AlphaBetaUpdate(benchmark::State& state) {
  const tws::AdaptiveAlphaBeta filter({});
  tws::AlphaBetaState track = filter.start(5e4, -100.0);
  Cycle innovations(-100.0, 100.0), times(0.1, 8.0);
  for ([[maybe_unused]] auto _ : state) {
    filter.update(track, innovations.next(), times.next());
    benchmark::DoNotOptimize(track);
  }
}
BENCHMARK(AlphaBetaUpdate);

// The loop of whoever runs one filter over many measurements.
template <class Filter>
void runFilter(benchmark::State& state, const Filter& filter) {
  const tws::AxisNoise noise{100.0, 5.0, 200.0};
  auto track = filter.start(5e4, noise);
  Cycle innovations(-100.0, 100.0), times(4.0, 8.0);
  for ([[maybe_unused]] auto _ : state) {
    filter.update(track, innovations.next(), times.next(), noise);
    benchmark::DoNotOptimize(track);
  }
}
void FixedGainUpdate(benchmark::State& state) { runFilter(state, tws::FixedGainFilter::withGains({0.5, 0.2, 0.03})); }
void TrackingIndexUpdate(benchmark::State& state) {
  runFilter(state, tws::FixedGainFilter::byTrackingIndex(static_cast<int>(state.range(0))));
}
void FixedMemoryUpdate(benchmark::State& state) {
  runFilter(state, tws::FixedMemoryFilter(1, static_cast<int>(state.range(0))));
}
void AxisKalmanVelocityUpdate(benchmark::State& state) { runFilter(state, tws::AxisKalman<2>()); }
void AxisKalmanAccelerationUpdate(benchmark::State& state) { runFilter(state, tws::AxisKalman<3>()); }
void ChosenFilterUpdate(benchmark::State& state) { runFilter(state, tws::AxisFilter(tws::AxisFilterParams{})); }
BENCHMARK(FixedGainUpdate);
BENCHMARK(TrackingIndexUpdate)->Arg(1)->Arg(2);
BENCHMARK(FixedMemoryUpdate)->Arg(4)->Arg(16);
BENCHMARK(AxisKalmanVelocityUpdate);
BENCHMARK(AxisKalmanAccelerationUpdate);
BENCHMARK(ChosenFilterUpdate);

void GainTableLookup(benchmark::State& state) {
  const tws::GainTable table(0.7);
  Cycle steps(0.0, 4.0);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(table.lookup(steps.next()));
}
BENCHMARK(GainTableLookup);

void KalmanConvert(benchmark::State& state) {
  Cycle azimuths(0.0, 6.28);
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(tws::convertedMeasurement(5e4, azimuths.next(), 50.0, 0.002));
}
BENCHMARK(KalmanConvert);

void KalmanPredict(benchmark::State& state) {
  tws::PlanarState track = tws::startState(tws::convertedMeasurement(5e4, 1.0, 50.0, 0.002), 200.0);
  const tws::PlanarState start = track;
  for ([[maybe_unused]] auto _ : state) {
    track = start;
    tws::predict(track, 4.0, 5.0);
    benchmark::DoNotOptimize(track);
  }
}
BENCHMARK(KalmanPredict);

void KalmanInnovation(benchmark::State& state) {
  const auto z = tws::convertedMeasurement(5e4, 1.0, 50.0, 0.002);
  tws::PlanarState track = tws::startState(z, 200.0);
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(track);
    benchmark::DoNotOptimize(tws::innovation(track, z));
  }
}
BENCHMARK(KalmanInnovation);

void KalmanPredictAndUpdate(benchmark::State& state) {
  const auto z = tws::convertedMeasurement(5e4, 1.0, 50.0, 0.002);
  tws::PlanarState track = tws::startState(z, 200.0);
  for ([[maybe_unused]] auto _ : state) {
    tws::predict(track, 4.0, 5.0);
    tws::update(track, z, tws::innovation(track, z));
    benchmark::DoNotOptimize(track);
  }
}
BENCHMARK(KalmanPredictAndUpdate);

void NumberFileTakeAndDrop(benchmark::State& state) {
  tws::NumberFile file(static_cast<std::uint32_t>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) file.drop(*file.take());
}
BENCHMARK(NumberFileTakeAndDrop)->Arg(256)->Arg(1000000);

void SectorFileMove(benchmark::State& state) {
  const auto numbers = static_cast<std::uint32_t>(state.range(0));
  tws::SectorFile file(numbers);
  for (std::uint32_t n = 0; n < numbers; ++n) file.addLast(n, static_cast<int>(n % 64));
  std::mt19937_64 generator(1);
  std::vector<std::uint32_t> order(4096);
  for (auto& n : order) n = static_cast<std::uint32_t>(generator() % numbers);
  std::size_t at = 0;
  for ([[maybe_unused]] auto _ : state) {
    const std::uint32_t n = order[at++ & 4095];
    const int sector = file.sector(n);
    file.remove(n);
    file.addFirst(n, tws::wrapSector(sector + 1));
  }
}
BENCHMARK(SectorFileMove)->Arg(256)->Arg(1000000);

void TimeOrderPushAndPop(benchmark::State& state) {
  const auto streams = static_cast<std::size_t>(state.range(0));
  tws::TimeOrder<std::uint64_t> order(streams);
  std::uint64_t count = 0;
  for ([[maybe_unused]] auto _ : state) {
    order.push(count % streams, static_cast<double>(count) * 0.01, count);
    ++count;
    while (auto item = order.pop()) benchmark::DoNotOptimize(item);
  }
}
BENCHMARK(TimeOrderPushAndPop)->Arg(2)->Arg(8);

void PolarFromEnu(benchmark::State& state) {
  Cycle axis(-1e5, 1e5);
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(tws::polarFromEnu({axis.next(), axis.next(), 5000.0}));
}
BENCHMARK(PolarFromEnu);

void GeodeticToEnuAndBack(benchmark::State& state) {
  const tws::LocalFrame frame({0.9, 0.1, 50.0});
  Cycle axis(-2e5, 2e5);
  for ([[maybe_unused]] auto _ : state) {
    benchmark::DoNotOptimize(frame.toEnu(frame.toGeodetic({axis.next(), axis.next(), 5000.0})));
  }
}
BENCHMARK(GeodeticToEnuAndBack);

/// Plots as a recording of a radar has them.
std::string tableOf(std::size_t rows) {
  std::string text = "t_s,radar,range_m,az_deg\n";
  char row[80];
  for (std::size_t i = 0; i < rows; ++i) {
    const auto number = static_cast<double>(i);
    std::snprintf(row, sizeof row, "%.3f,sps12,%.1f,%.4f\n", 0.01 * number, 5e4 + number, std::fmod(number, 360.0));
    text += row;
  }
  return text;
}

// Each row must cost the same, however many there are.
void CsvTableRows(benchmark::State& state) {
  const std::string text = tableOf(static_cast<std::size_t>(state.range(0)));
  for ([[maybe_unused]] auto _ : state) {
    std::istringstream input(text);
    tws::CsvTable table(input, "plots.csv");
    const std::size_t time = table.require("t_s"), azimuth = table.require("az_deg");
    while (table.next()) benchmark::DoNotOptimize(table.time(time) + table.number(azimuth));
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * state.range(0));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(CsvTableRows)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Complexity(benchmark::oN)
    ->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
