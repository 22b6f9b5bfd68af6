#pragma once

#include <ostream>
#include <string>
#include <vector>

#include <tws_core/csv_table.h>

#include "core/radar_counts.h"

namespace adit_tracker {

/// The rows of a file of clutter that hold what was learned of radars, a cell each: those with a depth. Such a row says
/// where its cell begins, and how many false plots came from it in how many scans, or how many targets were seen there
/// on how many looks.
class RadarCountsReader {
 public:
  /// `radars`: those that there are. The table must outlive the reader. Throws when it has some of the columns.
  RadarCountsReader(const tws::CsvTable& table, std::vector<std::string> radars);

  /// Is the table's row a cell?
  bool isCell() const { return !table_.text(depth_).empty(); }
  /// Takes it in. Throws std::runtime_error that names file, line and reason when it cannot be used.
  void addCell();
  /// Of each radar that had a cell.
  std::vector<RadarCounts> take();

 private:
  RadarCounts& countsOf(const std::string& radar);
  int sectorOfRow() const;
  int binOfRow(double depth) const;
  CellCount cellOfRow(std::size_t count, std::size_t looks) const;
  void addFalsePlots(RadarCounts& counts, double depth) const;
  void addCover(RadarCounts& counts, double depth) const;
  void add(CellCounts& counts, double depth, const CellCount& cell, const std::string& problem) const;

  const tws::CsvTable& table_;
  std::vector<std::string> radars_;
  std::vector<RadarCounts> counts_;
  std::size_t depth_;
  std::size_t radar_ = 0, range_ = 0, azimuth_ = 0, greatest_range_ = 0, false_plots_ = 0, scans_ = 0, seen_ = 0,
              looks_ = 0;
};

/// The columns of these rows, each with a comma before it, after those of clutter points.
extern const char* const kRadarCountsColumns;

/// Writes them so that the reader gives them back, to a thousandth of a false plot and a hundredth of a look.
void writeRadarCounts(std::ostream& output, const RadarCounts& counts);

}  // namespace adit_tracker
