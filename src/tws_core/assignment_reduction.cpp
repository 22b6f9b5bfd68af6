// Column and row reduction: what is cheap to find before the searches of assignment.cpp.
#include <algorithm>

#include "assignment.h"

namespace tws {

void AssignmentSolver::Cheapest::take(double cost, std::size_t at) {
  if (cost >= second) return;
  if (cost < first) {
    second = first;
    next_column = column;
    first = cost;
    column = static_cast<int>(at);
  } else {
    second = cost;
    next_column = static_cast<int>(at);
  }
}

AssignmentSolver::Cheapest AssignmentSolver::cheapest(Layout layout, std::size_t row) const {
  Cheapest cheapest;
  if (layout == Layout::kDense) {
    const double* costs = dense_ + row * columns_;
    for (std::size_t column = 0; column < columns_; ++column) cheapest.take(costs[column] - price_[column], column);
  } else {
    for (std::size_t e = first_edge_[row]; e < first_edge_[row + 1]; ++e)
      cheapest.take(edges_[e].cost - price_[edges_[e].column], edges_[e].column);
  }
  return cheapest;
}

/// Each column takes the row that is cheapest for it, unless another column has that row. Only where all columns will
/// be taken: elsewhere a free column's price is 0.
void AssignmentSolver::reduceColumns() {
  std::copy(dense_, dense_ + columns_, price_.begin());
  from_row_.assign(columns_, 0);
  for (std::uint32_t row = 1; row < rows_; ++row) {
    const double* costs = dense_ + row * columns_;
    for (std::size_t column = 0; column < columns_; ++column) {
      const bool is_cheaper = costs[column] < price_[column];
      price_[column] = is_cheaper ? costs[column] : price_[column];
      from_row_[column] = is_cheaper ? row : from_row_[column];
    }
  }
  done_.assign(columns_, 0);  // of rows: wanted by several columns
  for (std::size_t column = columns_; column-- > 0;) {
    const std::uint32_t row = from_row_[column];
    if (column_of_[row] != kUnassigned) {
      done_[row] = 1;
      continue;
    }
    column_of_[row] = static_cast<int>(column);
    row_of_[column] = static_cast<int>(row);
  }
  for (std::uint32_t row = 0; row < rows_; ++row) {
    if (column_of_[row] == kUnassigned)
      free_rows_.push_back(row);
    else if (done_[row] == 0)
      transferReduction(row);
  }
  std::fill(done_.begin(), done_.end(), 0);
}

/// Lets the price of the row's only column, its cheapest, fall as far as the row's second choice allows.
void AssignmentSolver::transferReduction(std::size_t row) {
  const Cheapest choice = cheapest(Layout::kDense, row);
  price_[column_of_[row]] -= choice.second - choice.first;
}

// Two rounds are what Jonker and Volgenant found to pay.
void AssignmentSolver::reduceRows(Layout layout) {
  for (int round = 0; round < 2; ++round) {
    next_free_.clear();
    for (const std::uint32_t row : free_rows_) reduceRow(layout, row, next_free_);
    free_rows_.swap(next_free_);
  }
}

/// Gives the row its cheapest column and lowers that column's price as far as the row's second choice allows. Whoever
/// had the column is left over, or at once gets another chance when the price fell.
void AssignmentSolver::reduceRow(Layout layout, std::size_t row, std::vector<std::uint32_t>& left) {
  // Prices that fall by little each time could keep two rows at it for long; the search does it better.
  for (std::size_t chances = 10; true; --chances) {
    const Cheapest choice = cheapest(layout, row);
    const double second = std::min(choice.second, miss_cost_);
    if (choice.first >= miss_cost_) {
      left.push_back(static_cast<std::uint32_t>(row));
      return;
    }
    int column = choice.column;
    const bool falls = second < kForbidden && price_[column] - (second - choice.first) < price_[column];
    if (falls)
      price_[column] -= second - choice.first;
    else if (row_of_[column] != kUnassigned && choice.next_column != kUnassigned && choice.second <= miss_cost_)
      column = choice.next_column;
    const int before = row_of_[column];
    row_of_[column] = static_cast<int>(row);
    column_of_[row] = column;
    if (before == kUnassigned) return;
    column_of_[before] = kUnassigned;
    if (!falls || chances == 0) {
      left.push_back(static_cast<std::uint32_t>(before));
      return;
    }
    row = static_cast<std::size_t>(before);
  }
}

}  // namespace tws
