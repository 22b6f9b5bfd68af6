#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace tws {

/// Cost of a pair that must not be made.
constexpr double kForbidden = std::numeric_limits<double>::infinity();

/// The exact least-cost assignment of rows (truths, tracks) to columns (tracks, plots), each used at most once.
///
/// Shortest augmenting paths with dual prices after R. Jonker and A. Volgenant, "A shortest augmenting path algorithm
/// for dense and sparse linear assignment problems", Computing 38, 1987: column reduction where every column will be
/// taken, augmenting row reduction, then one search a row that is left. A row may also end at a place of its own,
/// "unassigned", at the cost of a miss.
///
/// Keep a solver and use it again: it allocates only for a problem larger than all before. The same problem always
/// gives the same answer, also when several are equally good.
class AssignmentSolver {
 public:
  static constexpr int kUnassigned = -1;

  /// One pair that may be made.
  struct Pair {
    std::uint32_t row = 0;
    std::uint32_t column = 0;
    double cost = 0.0;
  };

  /// For each row its column, or kUnassigned. `costs` row by row, rows·columns of them, of any sign; kForbidden where
  /// the pair must not be made. Least is the sum of the pairs' costs and `miss_cost` for each row without a column.
  /// With the miss cost kForbidden as many pairs are made as can be, and of those solutions the cheapest is taken.
  ///
  /// O(rows · rows · columns) for rows ≤ columns. Valid until the next call. Throws std::invalid_argument that names
  /// the place when a cost is NaN or -∞, there are too few of them, or the miss cost is NaN or -∞.
  const std::vector<int>& solve(const std::vector<double>& costs, std::size_t rows, std::size_t columns,
                                double miss_cost = kForbidden);

  /// The same when few pairs may be made (gates): the pairs that are not listed are forbidden. In any order; of a pair
  /// listed twice the cheaper one counts. Throws also for a row or column outside.
  const std::vector<int>& solve(const std::vector<Pair>& pairs, std::size_t rows, std::size_t columns,
                                double miss_cost = kForbidden);

  /// Sum of the costs of the pairs made by the last call, misses not counted.
  double cost() const { return cost_; }

 private:
  struct Edge {
    std::uint32_t column;
    double cost;
  };
  struct Reached {  // a column in the queue of the sparse search
    double distance;
    std::uint32_t column;
  };
  struct Cheapest {  // of a row's reduced costs, the lowest two
    double first = kForbidden, second = kForbidden;
    int column = kUnassigned, next_column = kUnassigned;
    void take(double cost, std::size_t column);
  };
  enum class Layout { kDense, kSparse };

  void begin(std::size_t rows, std::size_t columns, double miss_cost, double span);
  void run(Layout layout);
  Cheapest cheapest(Layout layout, std::size_t row) const;
  void reduceColumns();
  void transferReduction(std::size_t row);
  void reduceRows(Layout layout);
  void reduceRow(Layout layout, std::size_t row, std::vector<std::uint32_t>& left);
  void augment(Layout layout, std::size_t row);
  void searchDense(std::size_t row);
  void searchSparse(std::size_t row);
  void takeMiss(std::size_t row, double distance);
  void updatePrices();
  void flip(std::size_t row);
  double costOf(Layout layout, std::size_t row, std::size_t column) const;
  const std::vector<int>& finish(Layout layout);
  void transpose(const std::vector<double>& costs, std::size_t rows, std::size_t columns);

  // The problem, turned so that rows_ ≤ columns_.
  std::size_t rows_ = 0, columns_ = 0;
  bool turned_ = false;
  double miss_cost_ = kForbidden;
  bool all_taken_ = false;  // Rows and columns are as many, and every pair may be made, but no miss.
  const double* dense_ = nullptr;
  std::vector<double> turned_costs_;
  std::vector<std::size_t> first_edge_;  // of each row, and one more
  std::vector<Edge> edges_;

  // The solution so far. A column that is free has price 0, unless every column will be taken in the end.
  std::vector<double> price_;  // v
  std::vector<int> column_of_, row_of_;
  std::vector<std::uint32_t> free_rows_, next_free_;

  // One search.
  std::vector<double> distance_;
  std::vector<std::uint32_t> from_row_;
  std::vector<std::uint32_t> scanned_, open_;
  std::vector<std::uint8_t> done_;
  std::vector<Reached> queue_;
  double end_distance_ = 0.0;
  int end_column_ = kUnassigned;
  int missed_row_ = kUnassigned;  // where the path ends when it ends at no column

  std::vector<int> answer_;
  double cost_ = 0.0;
};

}  // namespace tws
