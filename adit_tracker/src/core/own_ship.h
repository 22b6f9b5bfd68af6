#pragma once

#include <cstddef>
#include <deque>
#include <limits>
#include <optional>
#include <string>

#include "core/passage.h"

namespace adit_tracker {

/// Where own ship was, from poses with times. Between two poses it moved straight and turned evenly; nothing is made up
/// where too few poses came.
class OwnShip {
 public:
  static constexpr double kLongestGap = 10.0;           // between two poses [s]
  static constexpr double kLongestExtrapolation = 2.0;  // beyond the last pose before a gap, or the first after it [s]

  /// Takes a pose in. Returns why not, as a sentence without subject; empty: it was taken. Refused are poses that are
  /// no numbers, do not come after the one before, or lie further from it than a ship gets: more than 20 m and 50 m/s,
  /// or 20° and 45°/s. Where three refused ones in a row agree with each other, the track goes on from there, after a
  /// gap: a receiver has found its place, or time has begun anew, and then the old poses are forgotten. The
  /// latest pose again changes nothing.
  std::string add(double time, const Pose& pose);

  /// [s]; -infinity: none yet.
  double latest() const { return poses_.empty() ? -std::numeric_limits<double>::infinity() : poses_.back().time; }
  double first() const { return poses_.empty() ? std::numeric_limits<double>::infinity() : poses_.front().time; }
  std::size_t size() const { return poses_.size(); }

  /// Nothing: not known then.
  std::optional<Pose> at(double time) const;
  /// Over a sector: [begin, end].
  std::optional<Passage> over(double begin, double end) const;

  /// Of a run that goes on, what lies before that time [s] is not asked for any more.
  void forgetBefore(double time);
  void clear() { *this = OwnShip(); }

 private:
  struct Timed {
    double time;
    Pose pose;
    bool after_gap = false;  // it does not go on from the one before
  };
  static bool agree(const Timed& a, const Timed& b);
  static bool isSame(const Timed& a, const Timed& b);
  std::optional<Pose> beyond(std::size_t i, double time) const;
  bool isConnected(std::size_t i) const;
  void restart(const Timed& from);

  std::deque<Timed> poses_;
  std::optional<Timed> refused_;  // the latest one that was
  int agreeing_ = 0;              // refused ones in a row that agree with each other
};

}  // namespace adit_tracker
