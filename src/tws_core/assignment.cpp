#include "assignment.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tws {
namespace {

[[noreturn]] void refuse(double cost, std::size_t row, std::size_t column) {
  throw std::invalid_argument("assignment: cost of row " + std::to_string(row) + ", column " + std::to_string(column) +
                              " is " + std::to_string(cost));
}

constexpr std::size_t kLargeSquare = 16;  // below it, reducing columns first does not pay

bool usable(double cost) { return cost > -kForbidden; }  // false also for NaN

/// How far apart the costs that are not forbidden lie, 0 included.
class Span {
 public:
  void take(double cost) {
    if (cost == kForbidden) {
      forbidden_ = true;
      return;
    }
    least_ = std::min(least_, cost);
    greatest_ = std::max(greatest_, cost);
  }
  void forbid() { forbidden_ = true; }
  /// kForbidden when no pair is: then no row need be missed.
  double value() const { return forbidden_ ? greatest_ - least_ : kForbidden; }

 private:
  double least_ = 0.0, greatest_ = 0.0;
  bool forbidden_ = false;
};

/// Of a dense problem, whose costs it checks. Where nothing is forbidden, the usual case, one quick pass is all.
double spanOf(const std::vector<double>& costs, std::size_t rows, std::size_t columns) {
  int odd = 0;
  for (std::size_t i = 0; i < rows * columns; ++i) odd += std::abs(costs[i]) < kForbidden ? 0 : 1;
  if (odd == 0) return kForbidden;
  Span span;
  for (std::size_t i = 0; i < rows * columns; ++i) {
    if (!usable(costs[i])) refuse(costs[i], i / columns, i % columns);
    span.take(costs[i]);
  }
  return span.value();
}

constexpr auto later = [](const auto& a, const auto& b) {
  return a.distance > b.distance || (a.distance == b.distance && a.column > b.column);
};

}  // namespace

const std::vector<int>& AssignmentSolver::solve(const std::vector<double>& costs, std::size_t rows, std::size_t columns,
                                                double miss_cost) {
  if (costs.size() < rows * columns)
    throw std::invalid_argument("assignment: " + std::to_string(costs.size()) + " costs for " + std::to_string(rows) +
                                " rows and " + std::to_string(columns) + " columns");
  begin(rows, columns, miss_cost, spanOf(costs, rows, columns));
  dense_ = costs.data();
  if (turned_) transpose(costs, rows, columns);
  run(Layout::kDense);
  return finish(Layout::kDense);
}

const std::vector<int>& AssignmentSolver::solve(const std::vector<Pair>& pairs, std::size_t rows, std::size_t columns,
                                                double miss_cost) {
  Span span;
  span.forbid();
  for (const Pair& pair : pairs) {
    if (!usable(pair.cost)) refuse(pair.cost, pair.row, pair.column);
    if (pair.row >= rows || pair.column >= columns)
      throw std::invalid_argument("assignment: no row " + std::to_string(pair.row) + " or no column " +
                                  std::to_string(pair.column));
    span.take(pair.cost);
  }
  begin(rows, columns, miss_cost, span.value());
  first_edge_.assign(rows_ + 2, 0);
  for (const Pair& pair : pairs) ++first_edge_[(turned_ ? pair.column : pair.row) + 2];
  for (std::size_t i = 2; i < first_edge_.size(); ++i) first_edge_[i] += first_edge_[i - 1];
  edges_.resize(pairs.size());
  for (const Pair& pair : pairs) {
    const auto [row, column] = turned_ ? std::pair(pair.column, pair.row) : std::pair(pair.row, pair.column);
    edges_[first_edge_[row + 1]++] = {column, pair.cost};
  }
  run(Layout::kSparse);
  return finish(Layout::kSparse);
}

void AssignmentSolver::begin(std::size_t rows, std::size_t columns, double miss_cost, double span) {
  if (!usable(miss_cost)) throw std::invalid_argument("assignment: miss cost is " + std::to_string(miss_cost));
  turned_ = rows > columns;
  rows_ = std::min(rows, columns);
  columns_ = std::max(rows, columns);
  // A miss that no chain of pairs can outweigh, but small enough to keep the costs' last digits.
  miss_cost_ = miss_cost < kForbidden ? miss_cost : span * static_cast<double>(rows_ + 1) + 1.0;
  price_.assign(columns_, 0.0);
  column_of_.assign(rows_, kUnassigned);
  row_of_.assign(columns_, kUnassigned);
  distance_.assign(columns_, kForbidden);
  from_row_.resize(columns_);
  done_.assign(columns_, 0);
  all_taken_ = rows == columns && miss_cost == kForbidden && span == kForbidden;
}

void AssignmentSolver::transpose(const std::vector<double>& costs, std::size_t rows, std::size_t columns) {
  turned_costs_.resize(rows * columns);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column)
      turned_costs_[column * rows + row] = costs[row * columns + column];
  }
  dense_ = turned_costs_.data();
}

void AssignmentSolver::run(Layout layout) {
  free_rows_.clear();
  if (layout == Layout::kDense && all_taken_ && rows_ >= kLargeSquare)
    reduceColumns();
  else
    for (std::uint32_t row = 0; row < rows_; ++row) free_rows_.push_back(row);
  reduceRows(layout);
  for (const std::uint32_t row : free_rows_) augment(layout, row);
}

void AssignmentSolver::augment(Layout layout, std::size_t row) {
  end_distance_ = kForbidden;
  end_column_ = missed_row_ = kUnassigned;
  scanned_.clear();
  layout == Layout::kDense ? searchDense(row) : searchSparse(row);
  updatePrices();
  flip(row);
}

/// The row could end its path here, unassigned.
void AssignmentSolver::takeMiss(std::size_t row, double distance) {
  if (distance >= end_distance_) return;
  end_distance_ = distance;
  missed_row_ = static_cast<int>(row);
}

/// Dijkstra's search from a row over reduced costs to the nearest free column or miss.
void AssignmentSolver::searchDense(std::size_t row) {
  std::fill(distance_.begin(), distance_.end(), kForbidden);
  open_.resize(columns_);
  for (std::uint32_t column = 0; column < columns_; ++column) open_[column] = column;
  double offset = 0.0;  // distance of `row` less its own price u
  for (std::size_t at = row; true;) {
    takeMiss(at, miss_cost_ + offset);
    const double* costs = dense_ + at * columns_;
    double nearest = kForbidden;
    std::size_t place = 0;
    for (std::size_t i = 0; i < open_.size(); ++i) {
      const std::uint32_t column = open_[i];
      const double distance = costs[column] - price_[column] + offset;
      if (distance < distance_[column]) {
        distance_[column] = distance;
        from_row_[column] = static_cast<std::uint32_t>(at);
      }
      const double best = distance_[column];
      if (best < nearest || (best == nearest && nearest < kForbidden && row_of_[column] == kUnassigned &&
                             row_of_[open_[place]] != kUnassigned)) {
        nearest = best;
        place = i;
      }
    }
    if (nearest >= end_distance_) return;
    const std::uint32_t column = open_[place];
    if (row_of_[column] == kUnassigned) {
      end_distance_ = nearest;
      end_column_ = static_cast<int>(column);
      return;
    }
    scanned_.push_back(column);
    open_[place] = open_.back();
    open_.pop_back();
    at = static_cast<std::size_t>(row_of_[column]);
    offset = nearest - (dense_[at * columns_ + column] - price_[column]);
  }
}

void AssignmentSolver::searchSparse(std::size_t row) {
  queue_.clear();
  double offset = 0.0;
  open_.clear();  // the columns that were reached, to be forgotten afterwards
  for (std::size_t at = row; true;) {
    takeMiss(at, miss_cost_ + offset);
    for (std::size_t e = first_edge_[at]; e < first_edge_[at + 1]; ++e) {
      const std::uint32_t column = edges_[e].column;
      const double distance = edges_[e].cost - price_[column] + offset;
      if (done_[column] || distance >= distance_[column] || distance >= end_distance_) continue;
      if (distance_[column] == kForbidden) open_.push_back(column);
      distance_[column] = distance;
      from_row_[column] = static_cast<std::uint32_t>(at);
      queue_.push_back({distance, column});
      std::push_heap(queue_.begin(), queue_.end(), later);
    }
    while (!queue_.empty() && done_[queue_.front().column]) {
      std::pop_heap(queue_.begin(), queue_.end(), later);
      queue_.pop_back();
    }
    if (queue_.empty() || queue_.front().distance >= end_distance_) break;
    const std::uint32_t column = queue_.front().column;
    if (row_of_[column] == kUnassigned) {
      end_distance_ = distance_[column];
      end_column_ = static_cast<int>(column);
      break;
    }
    done_[column] = 1;
    scanned_.push_back(column);
    at = static_cast<std::size_t>(row_of_[column]);
    offset = distance_[column] - (costOf(Layout::kSparse, at, column) - price_[column]);
  }
}

void AssignmentSolver::updatePrices() {
  for (const std::uint32_t column : scanned_) price_[column] += distance_[column] - end_distance_;
}

/// Exchanges the pairs along the path that the search found.
void AssignmentSolver::flip(std::size_t row) {
  int column = end_column_;
  if (column == kUnassigned && missed_row_ != kUnassigned) {
    column = column_of_[missed_row_];
    column_of_[missed_row_] = kUnassigned;
  }
  while (column != kUnassigned) {
    const std::uint32_t from = from_row_[column];
    row_of_[column] = static_cast<int>(from);
    std::swap(column, column_of_[from]);
    if (from == row) break;
  }
  for (const std::uint32_t reached : open_) {
    distance_[reached] = kForbidden;
    done_[reached] = 0;
  }
}

double AssignmentSolver::costOf(Layout layout, std::size_t row, std::size_t column) const {
  if (layout == Layout::kDense) return dense_[row * columns_ + column];
  double cost = kForbidden;
  for (std::size_t e = first_edge_[row]; e < first_edge_[row + 1]; ++e)
    if (edges_[e].column == column) cost = std::min(cost, edges_[e].cost);
  return cost;
}

const std::vector<int>& AssignmentSolver::finish(Layout layout) {
  cost_ = 0.0;
  answer_.assign(turned_ ? columns_ : rows_, kUnassigned);
  for (std::size_t row = 0; row < rows_; ++row) {
    const int column = column_of_[row];
    if (column == kUnassigned) continue;
    cost_ += costOf(layout, row, static_cast<std::size_t>(column));
    turned_ ? answer_[column] = static_cast<int>(row) : answer_[row] = column;
  }
  return answer_;
}

}  // namespace tws
