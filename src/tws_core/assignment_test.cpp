#include <tws_core/assignment.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>

#include <tws_core/random_test_helpers.h>

namespace {

std::size_t allocations = 0;

}  // namespace

// Counts every allocation of this program; the test below looks at the difference. Sanitizers have their own.
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define COUNTS_ALLOCATIONS
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif

namespace tws {
namespace {

// If one of these fails, tracks get the wrong plots, or evaluations blame the wrong track.

using Pair = AssignmentSolver::Pair;

struct Problem {
  std::size_t rows = 0, columns = 0;
  std::vector<double> costs;
  double miss_cost = kForbidden;
};

struct Outcome {
  std::size_t pairs = 0;
  double cost = 0.0;
  bool betterThan(const Outcome& other, double miss_cost) const {
    if (miss_cost == kForbidden) return pairs != other.pairs ? pairs > other.pairs : cost < other.cost;
    return cost - static_cast<double>(pairs) * miss_cost < other.cost - static_cast<double>(other.pairs) * miss_cost;
  }
};

/// Tries everything.
void search(const Problem& problem, std::size_t row, unsigned used, Outcome so_far, Outcome& best) {
  if (row == problem.rows) {
    if (so_far.betterThan(best, problem.miss_cost)) best = so_far;
    return;
  }
  search(problem, row + 1, used, so_far, best);
  for (std::size_t column = 0; column < problem.columns; ++column) {
    const double cost = problem.costs[row * problem.columns + column];
    if ((used >> column & 1U) == 0 && cost < kForbidden)
      search(problem, row + 1, used | 1U << column, {so_far.pairs + 1, so_far.cost + cost}, best);
  }
}

Outcome bruteForce(const Problem& problem) {
  Outcome best;
  search(problem, 0, 0U, {}, best);
  return best;
}

/// Checks that the answer is an assignment and adds it up.
Outcome outcomeOf(const Problem& problem, const std::vector<int>& answer) {
  EXPECT_EQ(answer.size(), problem.rows);
  std::set<int> used;
  Outcome outcome;
  for (std::size_t row = 0; row < answer.size(); ++row) {
    if (answer[row] == AssignmentSolver::kUnassigned) continue;
    EXPECT_TRUE(used.insert(answer[row]).second) << "column " << answer[row] << " twice";
    outcome.cost += problem.costs[row * problem.columns + static_cast<std::size_t>(answer[row])];
    ++outcome.pairs;
  }
  return outcome;
}

std::vector<Pair> allowed(const Problem& problem) {
  std::vector<Pair> pairs;
  for (std::uint32_t row = 0; row < problem.rows; ++row) {
    for (std::uint32_t column = 0; column < problem.columns; ++column) {
      const double cost = problem.costs[row * problem.columns + column];
      if (cost < kForbidden) pairs.push_back({row, column, cost});
    }
  }
  return pairs;
}

/// `whole`: costs are small whole numbers, so that there are many ties.
Problem randomProblem(std::mt19937_64& generator, std::size_t rows, std::size_t columns, double density, bool whole) {
  Problem problem{rows, columns, {}, kForbidden};
  for (std::size_t i = 0; i < rows * columns; ++i) {
    const double cost = whole ? uniformInt(generator, -3, 6) : uniform(generator, -1.0, 2.0);
    problem.costs.push_back(uniform(generator, 0.0, 1.0) < density ? cost : kForbidden);
  }
  return problem;
}

void expectOptimal(AssignmentSolver& solver, const Problem& problem) {
  const Outcome best = bruteForce(problem);
  const double value =
      best.cost - (problem.miss_cost < kForbidden ? static_cast<double>(best.pairs) * problem.miss_cost : 0.0);
  for (const bool sparse : {false, true}) {
    const Outcome ours =
        outcomeOf(problem, sparse ? solver.solve(allowed(problem), problem.rows, problem.columns, problem.miss_cost)
                                  : solver.solve(problem.costs, problem.rows, problem.columns, problem.miss_cost));
    EXPECT_NEAR(solver.cost(), ours.cost, 1e-12);
    if (problem.miss_cost == kForbidden) {
      EXPECT_EQ(ours.pairs, best.pairs);
      EXPECT_NEAR(ours.cost, best.cost, 1e-9);
    } else {
      EXPECT_NEAR(ours.cost - ours.pairs * problem.miss_cost, value, 1e-9);
    }
  }
}

TEST(Assignment, IsTheBestOfAllForEveryShapeUpToEight) {
  auto generator = seededGenerator();
  AssignmentSolver solver;
  for (std::size_t rows = 0; rows <= 8; ++rows) {
    for (std::size_t columns = 0; columns <= 8; ++columns) {
      for (const double density : {1.0, 0.5, 0.2}) {
        for (const bool whole : {false, true}) {
          Problem problem = randomProblem(generator, rows, columns, density, whole);
          for (const double miss_cost : {kForbidden, 0.7, -1.0}) {
            problem.miss_cost = miss_cost;
            SCOPED_TRACE(testing::Message() << rows << " x " << columns << ", density " << density << ", whole "
                                            << whole << ", miss " << miss_cost);
            expectOptimal(solver, problem);
            if (HasFailure()) return;
          }
        }
      }
    }
  }
}

// Brute force cannot follow here, but the two forms of the problem go different ways.
TEST(Assignment, OfALargeProblemCostsTheSameWhetherDenseOrSparse) {
  auto generator = seededGenerator();
  AssignmentSolver solver;
  for (const auto& [rows, columns] : {std::pair<std::size_t, std::size_t>{17, 17}, {60, 60}, {40, 90}, {90, 40}}) {
    for (const double density : {1.0, 0.05}) {
      for (const bool whole : {false, true}) {
        const Problem problem = randomProblem(generator, rows, columns, density, whole);
        for (const double miss_cost : {kForbidden, 0.5}) {
          const Outcome dense = outcomeOf(problem, solver.solve(problem.costs, rows, columns, miss_cost));
          const Outcome sparse = outcomeOf(problem, solver.solve(allowed(problem), rows, columns, miss_cost));
          EXPECT_NEAR(dense.cost - (miss_cost < kForbidden ? dense.pairs * miss_cost : 0.0),
                      sparse.cost - (miss_cost < kForbidden ? sparse.pairs * miss_cost : 0.0), 1e-9);
          if (miss_cost == kForbidden) {
            EXPECT_EQ(dense.pairs, sparse.pairs);
          }
        }
      }
    }
  }
}

TEST(Assignment, TakesTheTwoSecondBestWhereTheBestPairWouldCostMore) {
  AssignmentSolver solver;
  // By hand: 1 + 9 = 10 against 2 + 3 = 5.
  EXPECT_EQ(solver.solve({1, 2, 3, 9}, 2, 2), (std::vector<int>{1, 0}));
  EXPECT_EQ(solver.cost(), 5.0);
}

TEST(Assignment, LeavesUnassignedWhatCostsMoreThanAMiss) {
  AssignmentSolver solver;
  const std::vector<double> costs{1, 5, 2, 9};
  // Both rows: 5 + 2 = 7, or 1 + 9 = 10; one row: 1 + miss.
  EXPECT_EQ(solver.solve(costs, 2, 2, 7.0), (std::vector<int>{1, 0}));
  EXPECT_EQ(solver.solve(costs, 2, 2, 5.0), (std::vector<int>{0, AssignmentSolver::kUnassigned}));
  EXPECT_EQ(solver.solve(costs, 2, 2, 0.5), (std::vector<int>{-1, -1}));
}

TEST(Assignment, AllocatesNothingWhenTheSolverIsUsedAgain) {
#ifndef COUNTS_ALLOCATIONS
  GTEST_SKIP() << "allocations are the sanitizer's";
#endif
  auto generator = seededGenerator();
  AssignmentSolver solver;
  const Problem large = randomProblem(generator, 40, 30, 0.3, false), small = randomProblem(generator, 9, 12, 1, false),
                square = randomProblem(generator, 30, 30, 1, false);
  const std::vector<Pair> pairs = allowed(large);
  const auto all = [&] {
    for (const Problem* problem : {&large, &small, &square})
      for (const double miss_cost : {kForbidden, 0.2})
        solver.solve(problem->costs, problem->rows, problem->columns, miss_cost);
    solver.solve(pairs, large.rows, large.columns);
  };
  all();
  const std::size_t before = allocations;
  all();
  EXPECT_EQ(allocations - before, 0U);
}

TEST(Assignment, GivesTheSameAnswerAgainWhateverWasSolvedBefore) {
  auto generator = seededGenerator();
  const Problem problem = randomProblem(generator, 12, 12, 0.8, true);  // many answers cost the same
  AssignmentSolver fresh, used;
  const std::vector<int> first = fresh.solve(problem.costs, 12, 12);
  used.solve(randomProblem(generator, 20, 17, 0.5, false).costs, 20, 17, 0.3);
  EXPECT_EQ(used.solve(problem.costs, 12, 12), first);
}

TEST(Assignment, NamesTheCostThatIsNoNumber) {
  AssignmentSolver solver;
  const auto reason = [&](auto... arguments) -> std::string {
    try {
      solver.solve(arguments...);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  const std::vector<double> costs{1, 2, 3, std::nan("")};
  EXPECT_EQ(reason(costs, 2, 2), "assignment: cost of row 1, column 1 is nan");
  EXPECT_EQ(reason(costs, 3, 2), "assignment: 4 costs for 3 rows and 2 columns");
  EXPECT_EQ(reason(std::vector<double>{1.0}, 1, 1, -kForbidden), "assignment: miss cost is -inf");
  EXPECT_EQ(reason(std::vector<Pair>{{0, 5, 1.0}}, 1, 2), "assignment: no row 0 or no column 5");
  EXPECT_EQ(reason(std::vector<Pair>{{0, 1, -kForbidden}}, 1, 2), "assignment: cost of row 0, column 1 is -inf");
}

// J. E. Beasley, OR-Library: assign500, whose optimum is published.
TEST(Assignment, ReachesThePublishedOptimumOfTheOrLibrary) {
  const char* shared = std::getenv("TWS_SHARED");
  if (shared == nullptr) GTEST_SKIP() << "TWS_SHARED is not set";
  const std::string command = "gzip -dc '" + std::string(shared) + "/data/assignment/assign500.txt.gz'";
  FILE* pipe = popen(command.c_str(), "r");
  std::string text;
  for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe)) text += static_cast<char>(c);
  ASSERT_EQ(pclose(pipe), 0);
  std::istringstream words(text);
  std::size_t n = 0;
  words >> n;
  std::vector<double> costs(n * n);
  for (double& cost : costs) words >> cost;
  ASSERT_TRUE(words);
  std::ifstream published(std::string(shared) + "/data/assignment/optimal.csv");
  std::string line;
  std::getline(published, line);
  double optimum = 0.0;
  char comma = 0;
  published >> n >> comma >> optimum;
  AssignmentSolver solver;
  solver.solve(costs, n, n);
  EXPECT_EQ(solver.cost(), optimum);
}

}  // namespace
}  // namespace tws
