#include "clutter/radar_counts_csv.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include <tws_core/sectors.h>

namespace adit_tracker {
namespace {

constexpr double kUntold = 0.0;  // no depth and no range
constexpr double kSectorDegrees = 360.0 / tws::kSectors;

/// Which multiple of `step` it is, 0 to `most`; -1: none.
int multipleOf(double value, double step, int most) {
  const double ratio = value / step;
  const bool is_multiple = ratio >= 0.0 && ratio <= most && std::abs(ratio - std::round(ratio)) < 1e-6;
  return is_multiple ? static_cast<int>(std::round(ratio)) : -1;
}

/// Where a cell begins, and its depth.
std::string placeOf(const RadarCounts& counts, const CellCounts& cells, int sector, int bin) {
  char text[100];
  std::snprintf(text, sizeof text, ",%.2f,%.3f,%.2f", bin * cells.depth, sector * kSectorDegrees, cells.depth);
  return counts.radar + text;
}

/// Does it say nothing, to the last digit written?
bool isEmpty(const CellCount& cell, double step) { return static_cast<double>(cell.looks) < 0.5 * step; }

void writeCell(std::ostream& output, const RadarCounts& counts, int sector, int bin) {
  char text[100];
  const CellCount& plots = counts.false_plots.at(sector, bin);
  if (!isEmpty(plots, 1e-3)) {
    std::snprintf(text, sizeof text, ",%.1f,%.3f,%.3f\n", counts.greatest_range, static_cast<double>(plots.count),
                  static_cast<double>(plots.looks));
    output << placeOf(counts, counts.false_plots, sector, bin) << text;
  }
  const CellCount& cover = counts.cover.at(sector, bin);
  if (isEmpty(cover, 1e-2)) return;
  std::snprintf(text, sizeof text, ",,,,%.2f,%.2f\n", static_cast<double>(cover.count),
                static_cast<double>(cover.looks));
  output << placeOf(counts, counts.cover, sector, bin) << text;
}

}  // namespace

const char* const kRadarCountsColumns = ",depth_m,greatest_range_m,false_plots,scans,seen,looks";

RadarCountsReader::RadarCountsReader(const tws::CsvTable& table, std::vector<std::string> radars)
    : table_(table), radars_(std::move(radars)), depth_(table.find("depth_m")) {
  if (depth_ == table.columns()) return;
  const std::pair<std::size_t&, const char*> columns[] = {{radar_, "radar"},
                                                          {range_, "range_m"},
                                                          {azimuth_, "az_deg"},
                                                          {greatest_range_, "greatest_range_m"},
                                                          {false_plots_, "false_plots"},
                                                          {scans_, "scans"},
                                                          {seen_, "seen"},
                                                          {looks_, "looks"}};
  for (const auto& [place, name] : columns) place = table.require(name);
}

RadarCounts& RadarCountsReader::countsOf(const std::string& radar) {
  if (std::find(radars_.begin(), radars_.end(), radar) == radars_.end())
    table_.fail(radar == "*" ? "a cell with depth_m is of one radar, not of all (*)"
                             : "there is no radar '" + radar + "'");
  const auto known = std::find_if(counts_.begin(), counts_.end(), [&](const auto& c) { return c.radar == radar; });
  if (known != counts_.end()) return *known;
  RadarCounts& counts = counts_.emplace_back();
  counts.radar = radar;
  counts.greatest_range = counts.false_plots.depth = counts.cover.depth = kUntold;
  return counts;
}

int RadarCountsReader::sectorOfRow() const {
  const int sector = multipleOf(table_.number(azimuth_), kSectorDegrees, tws::kSectors - 1);
  if (sector < 0) table_.fail("az_deg is not where a sector begins, a multiple of 5.625: " + table_.text(azimuth_));
  return sector;
}

int RadarCountsReader::binOfRow(double depth) const {
  const int bin = multipleOf(table_.number(range_), depth, CellCounts::kBins - 1);
  if (bin < 0) table_.fail("range_m is not where a cell begins, 0 to 64 times depth_m: " + table_.text(range_));
  return bin;
}

void RadarCountsReader::add(CellCounts& counts, double depth, const CellCount& cell, const std::string& problem) const {
  if (!problem.empty()) table_.fail(problem);
  if (counts.depth == kUntold) counts.depth = depth;
  if (counts.depth != depth) table_.fail("depth_m is not that of the radar's other cells: " + table_.text(depth_));
  CellCount& there = counts.at(sectorOfRow(), binOfRow(depth));
  if (there.looks > 0.0F) table_.fail("the cell has been told already");
  there = cell;
}

CellCount RadarCountsReader::cellOfRow(std::size_t count, std::size_t looks) const {
  return {static_cast<float>(table_.number(count)), static_cast<float>(table_.number(looks))};
}

void RadarCountsReader::addFalsePlots(RadarCounts& counts, double depth) const {
  const CellCount cell = cellOfRow(false_plots_, scans_);
  add(counts.false_plots, depth, cell, problemOfFalsePlots(cell));
  const double range = table_.number(greatest_range_);
  if (const std::string problem = problemOfRange(range, depth); !problem.empty()) table_.fail(problem);
  if (counts.greatest_range == kUntold) counts.greatest_range = range;
  if (counts.greatest_range != range) table_.fail("greatest_range_m is not that of the radar's other cells");
}

void RadarCountsReader::addCover(RadarCounts& counts, double depth) const {
  const CellCount cell = cellOfRow(seen_, looks_);
  add(counts.cover, depth, cell, problemOfCover(cell));
}

void RadarCountsReader::addCell() {
  RadarCounts& counts = countsOf(table_.text(radar_));
  const double depth = table_.number(depth_);
  if (const std::string problem = problemOfDepth(depth); !problem.empty()) table_.fail(problem);
  const bool has_scans = !table_.text(scans_).empty(), has_looks = !table_.text(looks_).empty();
  if (!has_scans && !has_looks) table_.fail("a cell with depth_m wants scans or looks");
  if (has_scans) addFalsePlots(counts, depth);
  if (has_looks) addCover(counts, depth);
}

/// What no row has told is as at the start.
std::vector<RadarCounts> RadarCountsReader::take() {
  const RadarCounts blank;
  for (RadarCounts& counts : counts_) {
    if (counts.greatest_range == kUntold) counts.greatest_range = blank.greatest_range;
    for (CellCounts* cells : {&counts.false_plots, &counts.cover}) {
      if (cells->depth == kUntold) cells->depth = blank.cover.depth;
    }
  }
  return std::move(counts_);
}

void writeRadarCounts(std::ostream& output, const RadarCounts& counts) {
  for (int sector = 0; sector < tws::kSectors; ++sector) {
    for (int bin = 0; bin < CellCounts::kBins; ++bin) writeCell(output, counts, sector, bin);
  }
}

}  // namespace adit_tracker
