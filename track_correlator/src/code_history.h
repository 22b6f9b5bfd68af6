#pragma once

#include <cstdint>
#include <limits>

#include "secondary_plot.h"

namespace track_correlator {

/// The code that a track's replies support. A code is held until another clean one has come a number of times in a
/// row, so that garbled replies do not change it and a pilot who dials a new code does.
class CodeHistory {
 public:
  /// Takes in a reply of this track. Garbled and missing ones say nothing. `replies_to_change` >= 1.
  void take(const CodeReply& reply, int replies_to_change);

  /// kNoCode until the first clean reply.
  std::uint16_t value() const { return value_; }

 private:
  std::uint16_t value_ = kNoCode;
  std::uint16_t rival_ = kNoCode;
  int rival_replies_ = 0;
};

/// The height that a track's replies support. A height that cannot be reached by climbing or sinking is held back until
/// the next one agrees with it.
class HeightHistory {
 public:
  /// `height` [m], NaN: none, at `time` [s]; `climb_limit` [m/s] is the fastest climb or descent accepted.
  void take(double height, bool garbled, double time, double climb_limit);

  /// [m]; NaN until the first clean reply.
  double value() const { return held_.height; }

 private:
  struct Sample {
    double height = std::numeric_limits<double>::quiet_NaN();
    double time = 0.0;
  };
  static bool reachable(const Sample& from, const Sample& to, double climb_limit);

  Sample held_, rival_;
};

}  // namespace track_correlator
