#pragma once

#include <map>
#include <set>
#include <vector>

#include "epoch.h"
#include "metric_list.h"
#include "sample.h"

namespace track_evaluation {

/// Who follows whom over time, from the pairs of a Matcher: swaps, breaks, initiation delay, the longest segment
/// (SIAP), spurious tracks, and MOTA (Bernardin and Stiefelhagen 2008, eq. (2)).
class Continuity {
 public:
  /// A truth that is found later than `initiation_limit` [s] after it is first required is not found in time.
  explicit Continuity(double initiation_limit) : initiation_limit_(initiation_limit) {}

  /// `track_of`: of each truth the index of its track or -1. `excused`: of each track, it follows nobody who counts.
  /// `counted`: the epoch lies in the evaluated interval; the others only tell who was found when.
  void add(const Epoch& epoch, const std::vector<int>& track_of, const std::vector<bool>& excused, bool counted);
  void report(MetricList& metrics) const;

 private:
  struct Life {                        // of a truth
    double first_required = kUnknown;  // [s]
    double found = kUnknown;           // first pair [s]
    bool ever_paired = false;
    std::uint32_t last_track = 0;
    bool lost = false;                                          // paired before and not now
    std::uint32_t segment_track = 0;                            // of the segment that is running
    double segment = 0.0, longest_segment = 0.0, epochs = 0.0;  // in counted epochs
  };
  struct Use {  // of a track, in counted epochs
    std::size_t paired = 0, lived = 0;
  };
  void addPair(Life& life, double time, std::uint32_t track, bool counted);
  void addUnpaired(Life& life, bool required, bool counted);
  void reportInitiation(MetricList& metrics) const;
  double truthHours() const;

  double initiation_limit_;
  std::map<std::uint32_t, Life> truths_;
  std::map<std::uint32_t, Use> tracks_;
  double swaps_ = 0.0, breaks_ = 0.0, misses_ = 0.0, false_ = 0.0, required_ = 0.0, epochs_ = 0.0;
  double last_time_ = kUnknown;
  Sample steps_;  // between epochs [s]
};

}  // namespace track_evaluation
