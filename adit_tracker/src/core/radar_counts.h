#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <tws_core/sectors.h>

#include "core/range_bins.h"

namespace adit_tracker {

/// How many have come from a cell, on how many looks at it; older ones count less.
struct CellCount {
  float count = 0.0F, looks = 0.0F;

  bool operator==(const CellCount& o) const { return count == o.count && looks == o.looks; }
};

/// The same for all cells: by sector, and by bin from the radar outward.
struct CellCounts {
  static constexpr int kBins = RangeBins::kBins + 1;  // the last is all that lies beyond the others
  static constexpr std::size_t kCells = std::size_t{tws::kSectors} * std::size_t{kBins};

  double depth = RangeBins().depth();  // of a bin [m]
  std::vector<CellCount> cells = std::vector<CellCount>(kCells);

  CellCount& at(int sector, int bin) { return cells[indexOf(sector, bin)]; }
  const CellCount& at(int sector, int bin) const { return cells[indexOf(sector, bin)]; }
  static std::size_t indexOf(int sector, int bin) {
    return static_cast<std::size_t>(sector) * std::size_t{kBins} + static_cast<std::size_t>(bin);
  }

  bool operator==(const CellCounts& o) const { return depth == o.depth && cells == o.cells; }
};

/// What the tracker has learned of a radar, as it is saved and loaded.
struct RadarCounts {
  std::string radar;
  double greatest_range = RangeBins::kLeastReach;  // of a plot [m]
  CellCounts false_plots;                          // on so many scans of what is covered of the cell
  CellCounts cover;  // targets that were detected, of those that the beam has met: the looks

  bool operator==(const RadarCounts& o) const {
    return radar == o.radar && greatest_range == o.greatest_range && false_plots == o.false_plots && cover == o.cover;
  }
};

/// Why they cannot be loaded, in the words of the file's columns; empty: they can.
std::string problemOfFalsePlots(const CellCount& cell);
std::string problemOfCover(const CellCount& cell);
std::string problemOfDepth(double depth);
/// Of the greatest range, with bins of that depth [m].
std::string problemOfRange(double greatest_range, double depth);
/// Of all.
std::string problemOf(const RadarCounts& counts);

}  // namespace adit_tracker
