#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>
#include <vector>

/// Solvers to compare with; nobody else uses them. Both take a square of costs, row by row, and return the least sum.
namespace classic {

/// "Basic level assignment": every assignment is tried.
inline double bruteForce(const std::vector<double>& costs, std::size_t n) {
  std::vector<std::size_t> column(n);
  std::iota(column.begin(), column.end(), 0);
  double least = std::numeric_limits<double>::infinity();
  do {
    double sum = 0.0;
    for (std::size_t row = 0; row < n; ++row) sum += costs[row * n + column[row]];
    least = std::min(least, sum);
  } while (std::next_permutation(column.begin(), column.end()));
  return least;
}

/// The algorithm of Munkres with starred and primed zeros and covered lines, as F. Bourgeois and J.-C. Lassalle print
/// it ("An extension of the Munkres algorithm for the assignment problem to rectangular matrices", Communications of
/// the ACM 14, 1971), step by step on the whole matrix.
class Munkres {
 public:
  double solve(const std::vector<double>& costs, std::size_t n) {
    begin(costs, n);
    while (coverStarredColumns() < n_) {
      Zero zero;
      while (!primeUntilFree(zero)) shiftUncovered();
      flipFrom(zero);
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < n_ * n_; ++i)
      if (mark_[i] == kStar) sum += costs[i];
    return sum;
  }

 private:
  enum Mark : std::uint8_t { kNone, kStar, kPrime };
  struct Zero {
    std::size_t row = 0, column = 0;
  };

  /// Preliminaries: each row less its least cost, and a star for each zero that has no other in its lines.
  void begin(const std::vector<double>& costs, std::size_t n) {
    n_ = n;
    costs_ = costs;
    mark_.assign(n * n, kNone);
    row_covered_.assign(n, false);
    column_covered_.assign(n, false);
    for (std::size_t row = 0; row < n; ++row) {
      const auto first = costs_.begin() + static_cast<std::ptrdiff_t>(row * n);
      const auto last = first + static_cast<std::ptrdiff_t>(n);
      const double least = *std::min_element(first, last);
      std::for_each(first, last, [&](double& cost) { cost -= least; });
      for (std::size_t column = 0; column < n; ++column) {
        if (costs_[row * n + column] != 0.0 || column_covered_[column]) continue;
        mark_[row * n + column] = kStar;
        column_covered_[column] = true;
        break;
      }
    }
  }

  std::size_t coverStarredColumns() {
    std::fill(row_covered_.begin(), row_covered_.end(), false);
    std::fill(column_covered_.begin(), column_covered_.end(), false);
    for (std::size_t i = 0; i < n_ * n_; ++i)
      if (mark_[i] == kStar) column_covered_[i % n_] = true;
    return static_cast<std::size_t>(std::count(column_covered_.begin(), column_covered_.end(), true));
  }

  /// Step 1: primes uncovered zeros; true at one whose row has no star, false when there are no more.
  bool primeUntilFree(Zero& zero) {
    for (std::size_t row = 0; row < n_; ++row) {
      for (std::size_t column = 0; column < n_ && !row_covered_[row]; ++column) {
        if (column_covered_[column] || costs_[row * n_ + column] != 0.0) continue;
        mark_[row * n_ + column] = kPrime;
        const std::size_t star = inRow(row, kStar);
        zero = {row, column};
        if (star == n_) return true;
        row_covered_[row] = true;
        column_covered_[star] = false;
        return primeUntilFree(zero);
      }
    }
    return false;
  }

  /// Step 2: along primes and stars in turn, each becomes the other.
  void flipFrom(Zero zero) {
    while (true) {
      std::size_t row = 0;
      while (row < n_ && mark_[row * n_ + zero.column] != kStar) ++row;
      mark_[zero.row * n_ + zero.column] = kStar;
      if (row == n_) break;
      mark_[row * n_ + zero.column] = kNone;
      zero = {row, inRow(row, kPrime)};
    }
    std::replace(mark_.begin(), mark_.end(), kPrime, kNone);
  }

  /// Step 3.
  void shiftUncovered() {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < n_ * n_; ++i)
      if (!row_covered_[i / n_] && !column_covered_[i % n_]) least = std::min(least, costs_[i]);
    for (std::size_t i = 0; i < n_ * n_; ++i) {
      if (row_covered_[i / n_]) costs_[i] += least;
      if (!column_covered_[i % n_]) costs_[i] -= least;
    }
  }

  std::size_t inRow(std::size_t row, Mark mark) const {
    std::size_t column = 0;
    while (column < n_ && mark_[row * n_ + column] != mark) ++column;
    return column;
  }

  std::size_t n_ = 0;
  std::vector<double> costs_;
  std::vector<Mark> mark_;
  std::vector<bool> row_covered_, column_covered_;
};

}  // namespace classic
