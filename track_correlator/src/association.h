#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <tws_core/assignment.h>

namespace track_correlator {

/// A primary and a secondary track, by index, that lie in each other's gate.
struct GatedPair {
  std::uint32_t primary = 0, secondary = 0;
  double distance = 0.0;  ///< Any measure, >= 0; sums of it are compared.
};

/// Gives each primary at most one secondary track. Pairs whose gates do not overlap with others are taken as they are;
/// each cluster of overlapping gates is solved by the optimal assignment (the paper's Munkres).
class Association {
 public:
  /// `gate` is the greatest distance in `pairs`: a pair costs no more than two tracks left alone. Each pair at most
  /// once. The answer, in order of the primaries, is valid until the next call.
  const std::vector<GatedPair>& solve(const std::vector<GatedPair>& pairs, std::size_t primaries,
                                      std::size_t secondaries, double gate);

  /// Clusters of more than one pair that the last call solved.
  std::size_t clusters() const { return clusters_; }

 private:
  std::uint32_t rootOf(std::uint32_t node);
  void findClusters(const std::vector<GatedPair>& pairs, std::size_t primaries, std::size_t secondaries);
  void solveCluster(const GatedPair* first, const GatedPair* last, double gate);

  std::vector<std::uint32_t> parent_;  // primaries first, then secondaries
  std::vector<GatedPair> sorted_, chosen_;
  std::vector<std::uint32_t> rows_, columns_;
  std::vector<tws::AssignmentSolver::Pair> costs_;
  tws::AssignmentSolver solver_;
  std::size_t clusters_ = 0;
};

}  // namespace track_correlator
