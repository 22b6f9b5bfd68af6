#pragma once

#include <tws_core/assignment.h>

#include <map>
#include <vector>

#include "epoch.h"

namespace track_evaluation {

/// Which track belongs to which truth, one to one, with memory: a pair of the epoch before is kept while both live and
/// are closer than the cut-off; of the rest as many pairs as possible are made at the least total distance.
/// K. Bernardin and R. Stiefelhagen, "Evaluating multiple object tracking performance: the CLEAR MOT metrics", EURASIP
/// J. Image and Video Processing 2008, section 2.1.2.
class Matcher {
 public:
  static constexpr int kNone = tws::AssignmentSolver::kUnassigned;

  /// cutoff [m] > 0.
  explicit Matcher(double cutoff) : cutoff_(cutoff) {}

  /// For each truth of the epoch the index of its track, or kNone. Valid until the next call.
  const std::vector<int>& match(const Epoch& epoch, const Distances& distances);

 private:
  void keepPairs(const Epoch& epoch, const Distances& distances);
  void assignRest(const Epoch& epoch, const Distances& distances);

  double cutoff_;
  tws::AssignmentSolver solver_;
  std::map<std::uint32_t, std::uint32_t> last_;  // pairs of the epoch before: truth to track
  std::vector<int> track_of_;
  std::vector<bool> taken_;
  std::vector<std::size_t> free_truths_, free_tracks_;
  std::vector<tws::AssignmentSolver::Pair> pairs_;
};

}  // namespace track_evaluation
