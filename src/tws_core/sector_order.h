#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <vector>

namespace tws {

/// A sector of one of several radars, by its running number.
struct SectorRef {
  std::size_t radar;
  std::int64_t running;
};

/// Decides which sector of asynchronously scanning radars is processed next (EXECUTIVE, figure 3, of NRL Report 7952):
/// the one that its radar crossed earliest, once that radar has closed as many sectors beyond it as the processing
/// looks at. The answer does not depend on how the messages of different radars interleave, as long as none is late by
/// more than the limit; a radar that falls silent does not hold up the rest.
class SectorOrder {
 public:
  /// `limit`: how late a radar's data may be against the newest of all before it counts as silent [s of data time].
  /// `ahead`: how many closed sectors the processing of one needs beyond it, ≥ 0.
  SectorOrder(std::size_t radars, double limit, std::int64_t ahead);

  /// A sector has closed. Within a radar, running numbers and times grow. Returns false when the sector is late:
  /// younger sectors of other radars have been handed out already (it is handed out all the same, next).
  bool add(const SectorRef& sector, double enter_time, double leave_time);

  /// The next sector to be processed; nothing: more data must come first.
  std::optional<SectorRef> next();

  /// How many sectors of each radar next() would hand out by now: what is left of them is nobody's fault but the
  /// caller's.
  std::vector<std::size_t> ready() const;
  /// Sectors that were added and not handed out yet, of all radars.
  std::size_t waiting() const;

  /// No more data will come: next() hands out all that is left.
  void finish() { finished_ = true; }

  /// The sector of a radar that follows the one handed out last: its front.
  std::int64_t front(std::size_t radar) const { return radars_[radar].next; }

  /// The latest sector that the radar has closed; -1: none yet.
  std::int64_t newest(std::size_t radar) const { return radars_[radar].newest; }

  /// Has nothing come of the radar for longer than the limit, as seen from the sector handed out last? Like front(), it
  /// follows from what was handed out, not from what has arrived, so that it is the same in every run.
  bool silent(std::size_t radar) const { return handed_out_ > radars_[radar].done_until + limit_; }

 private:
  static constexpr double kNever = -std::numeric_limits<double>::infinity();
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
    double done_until = kNever;  // leave time of the sector handed out last
    bool known = false;          // at least one of its sectors has come
  };

  std::optional<std::size_t> earliest() const;
  double nextTime(const Radar& radar) const;
  bool complete(const Radar& radar) const;
  bool overdue(const Radar& radar) const;
  bool holdsUp(std::size_t radar, std::size_t earliest) const;
  bool cannotPrecede(const Radar& radar, double time) const;

  std::vector<Radar> radars_;
  double limit_;
  std::int64_t ahead_;
  double newest_ = kNever;      // newest time of any radar
  double first_ = 0.0;          // first time of any radar
  double handed_out_ = kNever;  // enter time of the youngest sector handed out
  bool any_ = false;
  bool any_handed_out_ = false;
  bool finished_ = false;
};

}  // namespace tws
