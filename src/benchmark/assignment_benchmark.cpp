#include <benchmark/benchmark.h>

#include <algorithm>
#include <random>
#include <vector>

#include <tws_core/assignment.h>

namespace {

// The shapes of trackers: dense squares, twice as many plots as tracks, and gates that leave two or three plots a
// track.

std::vector<double> dense(std::size_t cells) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<double> costs(cells);
  for (double& cost : costs) cost = uniform(generator);
  return costs;
}

void AssignmentSquare(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const std::vector<double> costs = dense(n * n);
  tws::AssignmentSolver solver;
  for (auto _ : state) benchmark::DoNotOptimize(solver.solve(costs, n, n));
}
BENCHMARK(AssignmentSquare)->Arg(3)->Arg(5)->Arg(10)->Arg(50)->Arg(100)->Arg(300)->Arg(1000);

void AssignmentRectangle(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const std::vector<double> costs = dense(2 * n * n);
  tws::AssignmentSolver solver;
  for (auto _ : state) benchmark::DoNotOptimize(solver.solve(costs, n, 2 * n));
}
BENCHMARK(AssignmentRectangle)->Arg(3)->Arg(5)->Arg(10)->Arg(50)->Arg(100)->Arg(300)->Arg(1000);

std::vector<tws::AssignmentSolver::Pair> gated(std::size_t n) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::uniform_int_distribution<std::uint32_t> column(0, static_cast<std::uint32_t>(n) + 19);
  std::vector<tws::AssignmentSolver::Pair> pairs;
  for (std::uint32_t row = 0; row < n; ++row)
    for (std::uint32_t k = 0; k < 2 + row % 2; ++k) pairs.push_back({row, column(generator), uniform(generator)});
  return pairs;
}

void AssignmentGated(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const auto pairs = gated(n);
  tws::AssignmentSolver solver;
  for (auto _ : state) benchmark::DoNotOptimize(solver.solve(pairs, n, n + 20, 1.0));
}
BENCHMARK(AssignmentGated)->Arg(3)->Arg(5)->Arg(10)->Arg(50)->Arg(100)->Arg(300)->Arg(1000);

}  // namespace
