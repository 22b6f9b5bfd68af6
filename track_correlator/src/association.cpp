#include "association.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace track_correlator {
namespace {

/// Sorts and removes repetitions.
void tidy(std::vector<std::uint32_t>& numbers) {
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

std::uint32_t placeOf(std::uint32_t number, const std::vector<std::uint32_t>& numbers) {
  return static_cast<std::uint32_t>(std::lower_bound(numbers.begin(), numbers.end(), number) - numbers.begin());
}

}  // namespace

const std::vector<GatedPair>& Association::solve(const std::vector<GatedPair>& pairs, std::size_t primaries,
                                                 std::size_t secondaries, double gate) {
  chosen_.clear();
  clusters_ = 0;
  findClusters(pairs, primaries, secondaries);
  for (auto first = sorted_.begin(); first != sorted_.end();) {
    const std::uint32_t root = rootOf(first->primary);
    const auto last = std::find_if(first, sorted_.end(), [&](const auto& p) { return rootOf(p.primary) != root; });
    if (last - first == 1)
      chosen_.push_back(*first);
    else
      solveCluster(&*first, &*first + (last - first), gate);
    first = last;
  }
  std::sort(chosen_.begin(), chosen_.end(), [](const auto& a, const auto& b) { return a.primary < b.primary; });
  return chosen_;
}

std::uint32_t Association::rootOf(std::uint32_t node) {
  while (parent_[node] != node) node = parent_[node] = parent_[parent_[node]];
  return node;
}

/// Sorts the pairs by cluster.
void Association::findClusters(const std::vector<GatedPair>& pairs, std::size_t primaries, std::size_t secondaries) {
  parent_.resize(primaries + secondaries);
  std::iota(parent_.begin(), parent_.end(), 0U);
  for (const GatedPair& pair : pairs)
    parent_[rootOf(pair.primary)] = rootOf(static_cast<std::uint32_t>(primaries) + pair.secondary);
  sorted_ = pairs;
  std::sort(sorted_.begin(), sorted_.end(), [this](const GatedPair& a, const GatedPair& b) {
    return std::make_tuple(rootOf(a.primary), a.primary, a.secondary) <
           std::make_tuple(rootOf(b.primary), b.primary, b.secondary);
  });
}

void Association::solveCluster(const GatedPair* first, const GatedPair* last, double gate) {
  ++clusters_;
  rows_.clear();
  columns_.clear();
  for (const GatedPair* pair = first; pair != last; ++pair) {
    rows_.push_back(pair->primary);
    columns_.push_back(pair->secondary);
  }
  tidy(rows_);
  tidy(columns_);
  costs_.clear();
  for (const GatedPair* pair = first; pair != last; ++pair)
    costs_.push_back({placeOf(pair->primary, rows_), placeOf(pair->secondary, columns_), pair->distance});
  const std::vector<int>& column_of = solver_.solve(costs_, rows_.size(), columns_.size(), gate);
  for (const GatedPair* pair = first; pair != last; ++pair) {
    const int column = column_of[placeOf(pair->primary, rows_)];
    if (column >= 0 && columns_[static_cast<std::size_t>(column)] == pair->secondary) chosen_.push_back(*pair);
  }
}

}  // namespace track_correlator
