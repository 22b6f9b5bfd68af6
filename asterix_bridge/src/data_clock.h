#pragma once

#include <optional>

namespace asterix_bridge {

/// The time since 1970 [s], a whole number of `modulus` [s] from `time_of_day`, that lies nearest to `near` [s].
double nearestTime(double time_of_day, double modulus, double near);

/// Turns the times of day in the records of one feed into times since 1970 [s]. What is sent is known modulo a day
/// (CAT002, 034, 048) or modulo 512 s (CAT001); the whole is the one nearest to where the feed is now, so midnight
/// needs nothing of its own.
class DataClock {
 public:
  /// `near`: a time since 1970 that is less than 12 h from that of the first record.
  explicit DataClock(double near) : now_(near) {}

  /// A time since 1970 at which a block was received: the feed is there now.
  void receiveAt(double time);
  /// The same by the time of day alone, UTC [s].
  void receiveAtTimeOfDay(double time_of_day) { receiveAt(nearestTime(time_of_day, kDay, now_)); }

  /// The time of a record; NaN gives NaN. A time of day that lies more than a minute from where the feed is moves the
  /// feed only when the next one agrees: a single wrong one costs its own record only.
  double full(double time_of_day);
  /// The same from I001/141. As long as nothing else was heard it is right modulo 512 s only.
  double fullFromTruncated(double time);

  double now() const { return now_; }

 private:
  static constexpr double kDay = 86400.0;
  void move(double time);

  double now_;
  bool is_set_ = false;
  bool is_received_ = false;             // times of reception are known, and lead
  std::optional<double> contradiction_;  // the last time that was too far away to be believed alone
};

}  // namespace asterix_bridge
