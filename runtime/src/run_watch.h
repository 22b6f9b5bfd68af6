#pragma once

#include <cstdint>
#include <optional>

namespace tws_runtime {

/// The beam of a radar enters the sector with this running number at this time [s].
struct Crossing {
  std::int64_t running = 0;
  double time = 0.0;
};

/// Tells whether crossings belong to one run of a radar: running number and time must advance together, within what the
/// turning of an antenna allows. A mad stamp or number, a restarted radar and a restarted simulation do not fit.
class RunWatch {
 public:
  /// A time that lies more than `restart_limit` [s] before the newest one does not fit.
  explicit RunWatch(double restart_limit) : restart_limit_(restart_limit) {}

  /// Anything fits an empty run.
  bool fits(const Crossing& crossing) const;
  /// Whether it goes back by more than the limit: the mark of a new run.
  bool goesBack(const Crossing& crossing) const;
  /// Makes it part of the run.
  void take(const Crossing& crossing);
  /// A message's 32-bit number as one that never wraps: the one next to the newest number.
  std::int64_t unwrapped(std::uint32_t running) const;
  /// The crossing with the latest time; nothing in an empty run.
  const std::optional<Crossing>& newest() const { return newest_; }
  /// Forgets the run.
  void clear() { *this = RunWatch(restart_limit_); }

 private:
  double restart_limit_;
  std::optional<Crossing> newest_;
  double sector_time_ = 0.0;  ///< Smoothed time from crossing to crossing [s]; 0: unknown.
};

}  // namespace tws_runtime
