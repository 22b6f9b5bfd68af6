#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <tws_core/plot.h>

#include "io/plot_feed.h"

namespace adit_tracker {

/// How long a snapshot's sweep lasts in the sectors that are made of it [s]: nothing moves in it.
constexpr double kSnapshotSweep = 1e-3;

/// The distance between two snapshots [s], when the plots of one radar are snapshots: all of a scan have one time,
/// whatever their azimuths. Nothing: they are not, or too few to tell. A radar that turns and tells its times in coarse
/// steps is none: its plots of one time lie in one direction, which goes round from step to step; nor is one whose
/// times are those of its north mark (see moveWithTheBeam()). `plots`: in order of time.
std::optional<double> snapshotPeriod(const std::vector<tws::Plot>& plots);

/// Cuts snapshots into sectors: at each instant all 64 of them, by the plots' azimuths, within kSnapshotSweep before
/// it.
class SnapshotFeed : public PlotFeed {
 public:
  /// Plots in order of time, at least one; `period` [s], > kSnapshotSweep: of the snapshots.
  SnapshotFeed(std::vector<tws::Plot> plots, double period);

  std::optional<double> nextTime() const override;
  tws::RadarSector take() override;

 private:
  double sectorEnd(std::int64_t sector) const;
  void nextInstant();

  std::vector<tws::Plot> plots_;
  double period_;
  std::size_t first_ = 0, last_ = 0;  // of the plots of this instant: [first, last)
  double instant_ = 0.0;
  std::int64_t scan_ = 0, sector_ = 0;
};

}  // namespace adit_tracker
