#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include <tws_core/plot.h>

#include "track_window.h"

namespace range_gate_tracker {

struct HeldPlot {
  tws::Plot plot;
  std::int64_t running;  ///< Of its sector.
  bool used;
};

/// The plots of the latest sectors. What is in a window is found by range: the others cost nothing.
class HeldPlots {
 public:
  struct Sector {
    std::int64_t running;
    std::vector<HeldPlot> plots;          ///< As they came.
    std::vector<std::uint32_t> by_range;  ///< Their places in `plots`.
  };

  void add(std::int64_t running, const std::vector<tws::Plot>& plots);
  void forgetBefore(std::int64_t running);
  /// By sector, as they came. Stays good until plots are forgotten.
  std::vector<HeldPlot*> in(const TrackWindow& window);
  std::deque<Sector>& sectors() { return sectors_; }

 private:
  std::deque<Sector> sectors_;
};

}  // namespace range_gate_tracker
