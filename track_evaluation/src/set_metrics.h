#pragma once

#include <tws_core/assignment.h>

#include <vector>

#include "epoch.h"
#include "metric_list.h"

namespace track_evaluation {

/// Distances between the set of truths and the set of tracks, and the SIAP's picture of them; memoryless, one epoch
/// after the other.
///
/// OSPA: D. Schuhmacher, B.-T. Vo and B.-N. Vo, "A consistent metric for performance evaluation of multi-object
/// filters", IEEE Trans. Signal Processing 56(8), 2008, eq. (3).
/// GOSPA: A. S. Rahmathullah, A. F. Garcia-Fernandez and L. Svensson, "Generalized optimal sub-pattern assignment
/// metric", FUSION 2017, proposition 1 (alpha = 2): localisation, missed and false parts.
/// SIAP: P. Votruba et al., "Single Integrated Air Picture (SIAP) Metrics Implementation", SIAP SE TF Technical Report
/// 2001-001: each track goes to the nearest truth within the cut-off.
class SetMetrics {
 public:
  /// cutoff c [m] > 0, order p >= 1.
  SetMetrics(double cutoff, double order) : cutoff_(cutoff), order_(order) {}

  /// Of the epoch only these truths and tracks, by index.
  void add(const Epoch& epoch, const Distances& distances, const std::vector<std::size_t>& truths,
           const std::vector<std::size_t>& tracks);
  void report(MetricList& metrics) const;

  /// Of the epoch added last.
  struct Values {
    double ospa = 0.0, gospa = 0.0, localisation = 0.0, missed = 0.0, false_tracks = 0.0, completeness = kUnknown;
  };
  const Values& last() const { return last_; }

 private:
  struct Siap {
    double epochs = 0.0, truths = 0.0, tracks = 0.0, held = 0.0, associated = 0.0, distance = 0.0, speed_error = 0.0;
  };
  void addSets(const Distances& distances, const std::vector<std::size_t>& truths,
               const std::vector<std::size_t>& tracks);
  void addSiap(const Epoch& epoch, const Distances& distances, const std::vector<std::size_t>& truths,
               const std::vector<std::size_t>& tracks);

  double cutoff_, order_;
  tws::AssignmentSolver solver_;
  std::vector<tws::AssignmentSolver::Pair> pairs_;
  std::vector<bool> held_;
  Values sums_, last_;
  Siap siap_;
};

}  // namespace track_evaluation
