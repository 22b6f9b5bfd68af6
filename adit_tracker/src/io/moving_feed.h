#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <tws_core/plot.h>

#include "core/north_sectors.h"
#include "core/own_ship.h"
#include "io/plot_feed.h"

namespace adit_tracker {

/// What the azimuths and sectors of a feed are told against: north; the bow; or north, but by own ship's headings,
/// which have been added to azimuths told against the bow.
enum class AzimuthsFrom { kNorth, kBow, kHeadings };

/// The sectors of a radar on own ship against north, plots as measured, each with own ship's passage. Those for which
/// nobody knows it are left out and counted.
class MovingFeed {
 public:
  struct Sector {
    tws::RadarSector sector;
    Passage ship;
  };

  /// Both are to outlive it.
  MovingFeed(PlotFeed& feed, const OwnShip& ship, AzimuthsFrom from) : feed_(feed), ship_(ship), from_(from) {}

  /// When the feed's next sector closes; nothing: there are no more.
  std::optional<double> nextTime() const { return feed_.nextTime(); }
  /// The sectors that are complete with the feed's next one.
  std::vector<Sector> take();

  std::size_t lostSectors() const { return lost_sectors_; }
  std::size_t lostPlots() const { return lost_plots_; }

 private:
  void add(tws::RadarSector sector, std::vector<Sector>& ready);
  void lose(const tws::RadarSector& sector);

  PlotFeed& feed_;
  const OwnShip& ship_;
  AzimuthsFrom from_;
  NorthSectors north_;
  std::size_t lost_sectors_ = 0, lost_plots_ = 0;
};

}  // namespace adit_tracker
