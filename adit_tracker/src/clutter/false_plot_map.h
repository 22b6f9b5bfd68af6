#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include <tws_core/sectors.h>

#include "core/radar_counts.h"
#include "core/range_bins.h"

namespace adit_tracker {

/// Where a radar's false plots come from: their density over range and azimuth, learned from every plot by the chance
/// that it was false, and forgotten within some scans.
///
/// A cell is a sector wide and as deep as a 64th of the range covered; when a plot comes from beyond, two become one. A
/// cell that has shown little leans on the larger ones that hold it, of twice the size, four times and so on to all
/// that the radar covers: its density is the mean of a gamma distribution whose prior weighs as much as two plots. So a
/// single plot hardly changes the map, and a patch of clutter shows after a few scans.
///
/// Cost: five cells for a plot; for a sector, its cells.
class FalsePlotMap {
 public:
  FalsePlotMap();

  /// A plot has come from that range [m]: the radar sees at least so far.
  void addRange(double range);
  /// A plot in a sector (0..63), and the chance that it is false.
  void add(int sector, double range, double chance);
  /// All plots of that sector on this scan have been added.
  void close(int sector);

  /// Expected false plots a scan for each area at a place [1/m²].
  double density(double range, double azimuth) const;
  /// The same when so many of the plots that have lately been counted around there are a track's own: they speak for
  /// clutter in their cell, but not in the larger ones that hold it. As `density` where false plots are many.
  double densityAround(double plots, double range, double azimuth) const {
    return densityAround(plots, density(range, azimuth), range, azimuth);
  }
  /// For one who knows the density there already.
  double densityAround(double plots, double density, double range, double azimuth) const;
  /// Are false plots many where they come so densely [1/m²]? Then it matters little which of them are a track's own.
  bool areMany(double density) const { return density * area() > kMany; }
  /// How much of a plot still counts when its sector has been closed once more: eight scans are its time constant.
  static constexpr double kKept = 0.8825;
  /// Expected false plots a scan.
  double perScan() const;
  /// The same if they came as densely everywhere as at that place.
  double perScanAsAt(double range, double azimuth) const { return area() * density(range, azimuth); }
  /// The farthest plot so far, at least 10 km [m].
  double greatestRange() const { return greatest_range_; }

  /// Writes what has been counted, and the greatest range.
  void save(RadarCounts& counts) const;
  /// As if that had been seen, without problems (see problemOf): as on one scan at most, and nothing where one was
  /// made.
  void load(const RadarCounts& counts);

 private:
  static constexpr int kBins = RangeBins::kBins;
  static constexpr int kLevels = 5;       // cells of 1, 2, 4, 8, 16 sectors and bins
  static constexpr double kMany = 200.0;  // a scan, if they came as densely everywhere
  /// What a cell has shown lately.
  struct Cell {
    double plots = 0.0, exposure = 0.0;  // false ones, and its area [m²] times scans

    Cell& operator+=(const Cell& other) {
      plots += other.plots;
      exposure += other.exposure;
      return *this;
    }
  };

  double area() const;
  /// What lies beyond all bins is in the last.
  int binOf(double range) const { return std::min(bins_.binOf(range), kBins - 1); }
  /// It has not been closed yet.
  bool isNew(int sector) const { return sectors_[static_cast<std::size_t>(sector)].exposure == 0.0; }
  static std::size_t indexOf(int level, int sector, int bin) {
    const auto row = static_cast<std::size_t>(level) * tws::kSectors + static_cast<std::size_t>(sector >> level);
    return row * kBins + static_cast<std::size_t>(bin >> level);
  }
  Cell& at(int level, int sector, int bin) { return cells_[indexOf(level, sector, bin)]; }
  void widen();
  void sumUp(int sector);
  void total(int sector);
  /// Of a cell of that bin, as far as it is covered [m²].
  double areaOf(int bin) const;
  double estimate(int sector, int bin, double left_out) const;
  static FalsePlotMap mapOf(const RadarCounts& counts);
  void topUp(int sector, int bin, const Cell& loaded);

  double greatest_range_;
  RangeBins bins_;
  std::vector<Cell> cells_;                  // by level, sector and bin
  std::array<Cell, tws::kSectors> sectors_;  // sums
  Cell all_;                                 // the sum of these
  double everywhere_ = 0.0;                  // density of all that is covered, when a sector was closed last
};

}  // namespace adit_tracker
