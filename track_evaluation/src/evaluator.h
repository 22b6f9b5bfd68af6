#pragma once

#include <limits>
#include <vector>

#include "accuracy.h"
#include "continuity.h"
#include "epoch.h"
#include "matcher.h"
#include "metric_list.h"
#include "requirements.h"
#include "set_metrics.h"

namespace track_evaluation {

struct EvaluatorParams {
  double cutoff = 1000.0;  ///< c: a track further than this from a truth does not follow it [m], > 0.
  double order = 2.0;      ///< p of OSPA and GOSPA, >= 1.
  double from = 60.0;      ///< Epochs before this one only tell who was found when [s].
  double to = std::numeric_limits<double>::infinity();  ///< Epochs after it likewise [s].
  double initiation_limit = 40.0;                       ///< [s] after being required; "initiated_in_time".
  double nees_age = 1.0;                                ///< [s], see Accuracy.
};

/// Scores a tracker against truth, one epoch after the other; the same class live, on bags and on files.
///
/// A truth that is not required (a boat, an aircraft out of cover) costs nothing when it has no track, and excuses the
/// track that follows it: neither takes part in the set metrics.
class Evaluator {
 public:
  explicit Evaluator(const EvaluatorParams& params, std::vector<RequirementProfile> profiles = {});

  /// Throws std::invalid_argument, and changes nothing, when time does not go on, or a truth or track comes twice.
  void add(const Epoch& epoch);

  /// All metrics so far, in one fixed order.
  MetricList metrics() const;
  std::vector<RequirementRow> requirements() const;
  std::size_t epochs() const { return epochs_; }

  /// Of the epoch added last, for plots against time.
  const SetMetrics::Values& last() const { return sets_.last(); }
  /// Of each truth of the epoch added last the index of its track, or -1.
  const std::vector<int>& lastPairs() const { return track_of_; }

 private:
  void check(const Epoch& epoch) const;
  void sort(const Epoch& epoch);

  EvaluatorParams params_;
  double last_time_ = -std::numeric_limits<double>::infinity();
  std::size_t epochs_ = 0;
  Distances distances_;
  Matcher matcher_;
  SetMetrics sets_;
  Continuity continuity_;
  Accuracy accuracy_;
  std::vector<RequirementCounter> requirements_;
  std::vector<int> track_of_;
  std::vector<bool> excused_;
  std::vector<std::size_t> required_, judged_;
};

}  // namespace track_evaluation
