#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <tws_core/plot.h>
#include <tws_core/rotation.h>

#include "io/plot_feed.h"

namespace adit_tracker {

/// Cuts the plots of one radar into the sectors that its beam crossed: the sector marks that a file of plots lacks.
class SectorFeed : public PlotFeed {
 public:
  /// Plots in order of time; at least one.
  SectorFeed(std::vector<tws::Plot> plots, tws::Rotation rotation);

  std::optional<double> nextTime() const override;
  tws::RadarSector take() override;

 private:
  double start(std::int64_t running) const;
  void leap();

  std::vector<tws::Plot> plots_;
  tws::Rotation rotation_;
  std::int64_t whole_turns_;  // taken off, so that the running numbers start in the first turn
  std::int64_t running_;
  std::size_t next_ = 0;
  double enter_time_;
};

}  // namespace adit_tracker
