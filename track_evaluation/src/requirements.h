#pragma once

#include <map>
#include <string>
#include <vector>

#include "epoch.h"

namespace track_evaluation {

/// Limits in the manner of surveillance standards. A limit that is NaN is not asked for. config/requirements.yaml says
/// where the numbers come from.
struct RequirementProfile {
  std::string name;
  double update_interval = 8.0;           ///< [s] > 0
  double update_probability = kUnknown;   ///< At least, 0..1.
  double long_gap = kUnknown;             ///< A longer time between two updates is a long gap [s].
  double long_gap_share = kUnknown;       ///< Long gaps for each expected update, at most, 0..1.
  double horizontal_rms = kUnknown;       ///< [m], at most.
  double false_share = kUnknown;          ///< Of track reports that follow nobody, at most, 0..1.
  double mode_3a_probability = kUnknown;  ///< Updates with the right code, at least, 0..1.
  double mode_c_probability = kUnknown;   ///< Updates with the height right within height_error, at least, 0..1.
  double height_error = 100.0;            ///< [m] > 0
};

/// One line of the table.
struct RequirementRow {
  std::string profile, name, unit;
  double value = kUnknown;  ///< NaN: nothing in this run says it.
  double limit = kUnknown;
  bool at_least = false;  ///< Else at most.
  bool known() const { return value == value; }
  bool passed() const { return at_least ? value >= limit : value <= limit; }
};

/// Counts what one profile asks. Of each required truth the time in which it is required without a break is cut into
/// whole update intervals; each is expected to hold an update of the track that follows it. A time of g between two
/// updates (or from the begin, or to the end) misses ceil(g / interval) - 1 of them.
class RequirementCounter {
 public:
  explicit RequirementCounter(RequirementProfile profile) : profile_(std::move(profile)) {}

  /// As Continuity::add, for epochs that count. A track without a time of its last update is updated at each epoch.
  void add(const Epoch& epoch, const std::vector<int>& track_of, const std::vector<bool>& excused);
  void report(std::vector<RequirementRow>& rows) const;

 private:
  struct Watch {  // of a truth that is required
    double begin = 0.0, end = 0.0, last_update = 0.0;
    bool open = false;
  };
  struct Counts {
    double expected = 0.0, missed = 0.0, long_gaps = 0.0;
  };
  void addUpdate(Watch& watch, const TruthState& truth, const TrackState& track, double time);
  void addGap(Counts& counts, double length) const;
  void close(Watch& watch, Counts& counts) const;

  RequirementProfile profile_;
  std::map<std::uint32_t, Watch> watches_;
  double last_epoch_ = kUnknown;
  Counts counts_;
  double squares_ = 0.0, pairs_ = 0.0, reports_ = 0.0, false_ = 0.0;
  double coded_ = 0.0, right_code_ = 0.0, high_ = 0.0, right_height_ = 0.0;
  bool codes_reported_ = false, heights_reported_ = false;
};

}  // namespace track_evaluation
