#include <benchmark/benchmark.h>

#include <cmath>
#include <random>

#include "correlator_test_helpers.h"

namespace {

using track_correlator::Scheme;
using track_correlator::trackInput;

/// Aircraft at random in a disk of 200 km, each tracked by both radars with errors of 60 m and 5 m/s.
class Sky {
 public:
  explicit Sky(std::size_t count) : aircraft_(count) {
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (Aircraft& one : aircraft_) {
      const double range = 200e3 * std::sqrt(uniform(generator_)), azimuth = tws::kTwoPi * uniform(generator_);
      const double speed = 100.0 + 200.0 * uniform(generator_), course = tws::kTwoPi * uniform(generator_);
      one = {range * std::sin(azimuth), range * std::cos(azimuth), speed * std::sin(course), speed * std::cos(course)};
    }
  }

  /// All that the trackers say in one turn.
  void tell(track_correlator::CorrelatorListener& listener) {
    const double t = listener.now();
    for (std::uint32_t i = 0; i < aircraft_.size(); ++i) {
      listener.correlator.addPrimary(observed(i, t));
      listener.correlator.addSecondary(observed(i, t));
    }
  }

 private:
  struct Aircraft {
    double x, y, vx, vy;
  };
  track_correlator::TrackInput observed(std::uint32_t i, double t) {
    const Aircraft& a = aircraft_[i];
    const auto error = [&](double sigma) { return std::normal_distribution<double>(0.0, sigma)(generator_); };
    return trackInput(i, t, a.x + a.vx * t + error(60.0), a.y + a.vy * t + error(60.0), a.vx + error(5.0),
                      a.vy + error(5.0), 60.0, 5.0);
  }

  std::mt19937_64 generator_{1};
  std::vector<Aircraft> aircraft_;
};

/// One turn of 64 sectors; telling the tracks is not in the time.
void turns(benchmark::State& state, Scheme scheme, int turns_before) {
  Sky sky(static_cast<std::size_t>(state.range(0)));
  track_correlator::CorrelatorParams params;
  params.fusion.scheme = scheme;
  track_correlator::CorrelatorListener listener(params);
  listener.period = 6.0;
  for (int i = 0; i < turns_before; ++i) {
    sky.tell(listener);
    listener.turn();
  }
  for (auto _ : state) {
    state.PauseTiming();
    listener.reports.clear();
    sky.tell(listener);
    state.ResumeTiming();
    listener.turn();
  }
  state.counters["s/sector"] =
      benchmark::Counter(tws::kSectors, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// All pairs are in the fusion table: what a correlator does all day.
void CorrelatorTurnByHistory(benchmark::State& state) { turns(state, Scheme::kParallelCounter, 5); }
BENCHMARK(CorrelatorTurnByHistory)->Arg(60)->Arg(250)->Arg(1000)->Arg(4000)->Arg(10000)->Unit(benchmark::kMicrosecond);

// All pairs are found anew in every turn.
void CorrelatorTurnByDistance(benchmark::State& state) { turns(state, Scheme::kDistance, 1); }
BENCHMARK(CorrelatorTurnByDistance)->Arg(60)->Arg(250)->Arg(1000)->Arg(4000)->Arg(10000)->Unit(benchmark::kMicrosecond);

}  // namespace

BENCHMARK_MAIN();
