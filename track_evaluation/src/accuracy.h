#pragma once

#include "epoch.h"
#include "metric_list.h"
#include "sample.h"

namespace track_evaluation {

/// Errors of the pairs of a Matcher: root mean square, along and across the truth's course, and the normalised
/// estimation error squared e'P^-1 e (Y. Bar-Shalom, X. R. Li and T. Kirubarajan, "Estimation with Applications to
/// Tracking and Navigation", 2001, eq. (5.4.2-1)), whose mean is the number of dimensions when the covariance is
/// honest.
class Accuracy {
 public:
  /// NEES only of tracks that were updated at most `nees_age` [s] before, for the extrapolated covariance holds no
  /// process noise.
  explicit Accuracy(double nees_age) : nees_age_(nees_age) {}

  void add(const TruthState& truth, const TrackState& track);
  void report(MetricList& metrics) const;

 private:
  double nees_age_;
  Sample position_;
  Moments velocity_, along_, across_, nees_position_, nees_state_;
};

}  // namespace track_evaluation
