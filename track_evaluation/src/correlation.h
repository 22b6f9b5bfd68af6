#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "epoch.h"
#include "metric_list.h"

namespace track_evaluation {

/// Whether a picture of correlated tracks gives each aircraft its own code, update by update. Sampath Kumar, Viji Paul
/// and Ramakrishnan count so: their table 1 is the number of scans with a wrong pair. doc/metrics.md defines the
/// metrics.
class CorrelationMetrics {
 public:
  enum class Kind { kPrimaryOnly, kSecondaryOnly, kCorrelated };

  /// An update of a living track of the correlator.
  struct Update {
    std::uint32_t identity = 0;
    Kind kind = Kind::kPrimaryOnly;
    std::uint16_t mode_3a = kCodeUnknown;
  };

  void add(const Update& update);
  /// The updates since the last call are about the truths that their identities are paired with now, or about that one
  /// whose code they bear when the track is nearer to it by 100 m. `track_of`: of each truth of the epoch the index of
  /// its track or -1.
  void judge(const Epoch& epoch, const std::vector<int>& track_of);

  bool empty() const { return updates_[0] + updates_[1] + updates_[2] == 0; }
  MetricList report() const;

 private:
  double updates_[3] = {};  // by kind
  std::vector<Update> waiting_;
  double judged_ = 0.0, wrong_ = 0.0;
  double first_time_ = kUnknown, last_time_ = kUnknown;  // epochs [s]
};

}  // namespace track_evaluation
