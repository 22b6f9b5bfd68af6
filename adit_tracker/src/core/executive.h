#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <vector>

namespace adit_tracker {

/// Decides whose sector comes next (the report's EXECUTIVE, figure 3): the one that its radar crossed earliest, once
/// that radar has closed the sectors that the clutter map needs. The answer does not depend on how the messages of
/// different radars interleave, as long as none is late by more than the limit; a radar that falls silent does not hold
/// up the rest.
class Executive {
 public:
  struct Turn {
    std::size_t radar;
    std::int64_t running;
  };
  /// The clutter map works on sector +3 with the detections of sector +4.
  static constexpr std::int64_t kSectorsAhead = 4;

  /// `limit`: how late a radar's data may be against the newest of all before it counts as silent [s of data time].
  Executive(std::size_t radars, double limit);

  /// A sector has closed. Within a radar, running numbers and times grow. Returns false when the sector is late:
  /// younger sectors of other radars have been handed out already (it is handed out all the same, next).
  bool closed(std::size_t radar, std::int64_t running, double enter_time, double leave_time);

  /// The next sector to be processed; nothing: more data must come first.
  std::optional<Turn> next();

  /// How many sectors of each radar next() would hand out by now: what is left of them is nobody's fault but the
  /// caller's.
  std::vector<std::size_t> ready() const;

  /// No more data will come: next() hands out all that is left.
  void finish() { finished_ = true; }

  /// The sector of a radar that follows the one handed out last: its front.
  std::int64_t front(std::size_t radar) const;

  /// The latest sector that the radar has closed; -1: none yet.
  std::int64_t newest(std::size_t radar) const { return radars_[radar].newest; }

  /// Has the radar not been heard of for longer than the limit, as seen from the sector handed out last? Like front(),
  /// it follows from what was handed out, not from what has arrived, so that it is the same in every run.
  bool silent(std::size_t radar) const;

 private:
  struct Pending {
    std::int64_t running;
    double enter_time, leave_time;
  };
  struct Radar {
    std::deque<Pending> pending;
    std::int64_t newest = -1;
    std::int64_t next = 0;
    double newest_leave = 0.0;
    double sector_duration = 0.0;
    double done_until = -std::numeric_limits<double>::infinity();  // leave time of the sector handed out last
    bool heard = false;
  };

  double nextTime(const Radar& radar) const;
  bool ready(const Radar& radar) const;
  bool overdue(const Radar& radar) const;
  bool mayYieldTo(const Radar& radar, double time) const;

  std::vector<Radar> radars_;
  double limit_;
  double newest_ = 0.0;      // newest time of any radar
  double first_ = 0.0;       // first time of any radar
  double handed_out_ = 0.0;  // enter time of the youngest sector handed out
  bool any_ = false;
  bool any_handed_out_ = false;
  bool finished_ = false;
};

}  // namespace adit_tracker
