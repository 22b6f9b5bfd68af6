#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace track_correlator {

/// The beam of the clocking radar entered the sector with that running number at `time` [s].
struct Mark {
  std::int64_t running = 0;
  double time = 0.0;
};

/// The sector marks that clock the correlation: a fixed number of sectors behind the beam, each once and in order.
class MarkClock {
 public:
  /// `delay`: sectors behind the beam (Δ₂), >= 0.
  explicit MarkClock(int delay) : delay_(static_cast<std::size_t>(delay)) {}

  struct Step {
    std::vector<Mark> due;   ///< To be processed now; missing ones are filled in.
    std::size_t lost = 0;    ///< So many were filled in.
    bool stray = false;      ///< The number is out of line; the mark is left out.
    bool restarted = false;  ///< Two out of line agree: the radar counts anew from here on.
  };
  Step add(const Mark& mark);

 private:
  void enter(const Mark& mark, Step& step);

  std::size_t delay_;
  std::deque<Mark> marks_;  // those that are not due yet
  std::optional<Mark> newest_;
  std::optional<std::int64_t> stray_;
};

}  // namespace track_correlator
