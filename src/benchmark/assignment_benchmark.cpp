#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <tws_core/assignment.h>

#include "classic_solvers.h"

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

/// Refuses to compare with a solver that is wrong.
void compare(benchmark::State& state, double classic, const std::vector<double>& costs, std::size_t n) {
  tws::AssignmentSolver solver;
  solver.solve(costs, n, n);
  if (std::abs(solver.cost() - classic) > 1e-9) state.SkipWithError("the two solvers do not agree");
}

// The paper's figure 10 compares these two for 3, 5 and 10 tracks.
void AssignmentClassicMunkres(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const std::vector<double> costs = dense(n * n);
  classic::Munkres munkres;
  compare(state, munkres.solve(costs, n), costs, n);
  for (auto _ : state) benchmark::DoNotOptimize(munkres.solve(costs, n));
}
// For 1000 it takes a minute.
BENCHMARK(AssignmentClassicMunkres)->Arg(3)->Arg(5)->Arg(10)->Arg(50)->Arg(100)->Arg(300);

void AssignmentBruteForce(benchmark::State& state) {
  const auto n = static_cast<std::size_t>(state.range(0));
  const std::vector<double> costs = dense(n * n);
  compare(state, classic::bruteForce(costs, n), costs, n);
  for (auto _ : state) benchmark::DoNotOptimize(classic::bruteForce(costs, n));
}
BENCHMARK(AssignmentBruteForce)->Arg(3)->Arg(5)->Arg(10);

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
