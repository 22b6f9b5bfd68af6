#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include <tws_core/sectors.h>

#include "core/radar_counts.h"
#include "core/range_bins.h"

namespace adit_tracker {

/// What a radar covers: its chance of detection over range and azimuth, learned from firm tracks that its beam meets,
/// and the range beyond which it sees nothing.
///
/// A cell is a sector wide and as deep as a 64th of the range covered; when a plot comes from beyond, two become one.
/// What lies beyond all of them is one cell. A cell that has shown little leans on what the others of the same range
/// have: of its 4 sectors, of the other 12 of 16, of all others, each prior of the next with the weight of three looks,
/// and the first leans on the ranges before it. So a few tracks that leave in several directions teach the radar's
/// greatest range, and many a blind sector; what one lost track has missed is counted once, and blinds no more than its
/// own sectors. Old looks are forgotten as new ones come. While the radar sees little anywhere, misses count little: it
/// may be off.
///
/// Where false plots come from all ranges and sides, the greatest range shows sooner: none come from beyond it.
///
/// Cost: 13 cells a look; to ask, seven, and those before it as far as little is known of them: at most 64 more.
class CoverageMap {
 public:
  CoverageMap();

  /// A beam has met a target at that range [m] and azimuth [rad, 0 to 2π), and seen it with this chance; `weight`: the
  /// chance that there was one. Both 0 to 1.
  void look(double range, double azimuth, double seen, double weight);
  /// A plot has come from there, and is false with this chance.
  void addPlot(double range, double azimuth, double chance_false);

  /// The chance of detection there, 0 to 1.
  double detection(double range, double azimuth) const;
  /// Does the radar see hardly anything there?
  bool isBlind(double range, double azimuth) const;
  /// Has the beam met any target yet?
  bool hasLooked() const { return has_looked_; }

  /// Writes what targets have shown.
  void save(RadarCounts& counts) const;
  /// As if that had been seen, without problems (see problemOf): a few looks a cell, less those made already.
  void load(const RadarCounts& counts);

 private:
  static constexpr int kBins = RangeBins::kBins;
  static constexpr int kLevels = 4;  // cells of 1, 4, 16, 64 sectors
  static constexpr int kQuadrants = 4;
  struct Cell {
    float seen = 0.0F, looks = 0.0F;

    Cell& operator+=(const Cell& other) {
      seen += other.seen;
      looks += other.looks;
      return *this;
    }
    /// Of as many looks at most, in the same proportion.
    Cell atMost(float most) const { return looks > most ? Cell{seen * most / looks, most} : *this; }
    Cell without(const Cell& part) const {
      return {std::max(0.0F, seen - part.seen), std::max(0.0F, looks - part.looks)};
    }
  };

  static double after(const Cell& cell, double prior, double weight);
  double priorOf(int bin) const;
  static std::size_t indexOf(int level, int sector, int bin) {
    const auto row = static_cast<std::size_t>(level) * tws::kSectors + static_cast<std::size_t>(sector >> (2 * level));
    return row * (kBins + 1) + static_cast<std::size_t>(bin);
  }
  const Cell& at(int level, int sector, int bin) const { return cells_[indexOf(level, sector, bin)]; }
  /// What a cell says to the larger one that holds it.
  Cell saidBy(int level, int sector, int bin) const;
  void sumUp(int sector, int bin);
  void sumUp();
  static void topUp(Cell& cell, const Cell& loaded);
  void widen();
  bool isBeyond(double range) const;

  RangeBins bins_;
  int outside_ = 0;                               // plots from beyond all bins
  double farthest_ = 0.0, farthest_false_ = 0.0;  // of all plots, and of those that are rather false [m]
  std::array<std::array<double, kBins>, kQuadrants> false_plots_{};  // since the start, by quadrant and bin
  bool has_looked_ = false;
  double everywhere_;        // share of the latest looks that saw something
  std::vector<Cell> cells_;  // by level, sector and bin, of which the last is all that lies beyond
};

}  // namespace adit_tracker
