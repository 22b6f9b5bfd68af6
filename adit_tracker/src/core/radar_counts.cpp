#include "core/radar_counts.h"

#include <cstdio>
#include <functional>

namespace adit_tracker {
namespace {

// Of one cell: far beyond what comes, and far from what floats cannot hold.
constexpr float kMostPlots = 1e5F, kMostScans = 100.0F, kMostLooks = 1e5F;

std::string unfit(const char* what, double value) {
  char text[80];
  std::snprintf(text, sizeof text, "%s: %.10g", what, value);
  return text;
}

bool isWithin(float value, float most) { return value >= 0.0F && value <= most; }

std::string problemOfCells(const CellCounts& counts, const std::function<std::string(const CellCount&)>& problem_of) {
  if (counts.cells.size() != CellCounts::kCells)
    return std::to_string(counts.cells.size()) + " cells in place of " + std::to_string(CellCounts::kCells);
  for (const CellCount& cell : counts.cells) {
    if (std::string problem = problem_of(cell); !problem.empty()) return problem;
  }
  return problemOfDepth(counts.depth);
}

}  // namespace

std::string problemOfFalsePlots(const CellCount& cell) {
  if (!isWithin(cell.count, kMostPlots)) return unfit("false_plots is not in [0, 1e5]", cell.count);
  if (!isWithin(cell.looks, kMostScans)) return unfit("scans is not in [0, 100]", cell.looks);
  return "";
}

std::string problemOfCover(const CellCount& cell) {
  if (!isWithin(cell.looks, kMostLooks)) return unfit("looks is not in [0, 1e5]", cell.looks);
  if (!isWithin(cell.count, cell.looks)) return unfit("seen is not in [0, looks]", cell.count);
  return "";
}

std::string problemOfDepth(double depth) {
  return RangeBins::isDepth(depth) ? "" : unfit("depth_m is not 156.25 times 1, 2, 4, ... 1024", depth);
}

std::string problemOfRange(double greatest_range, double depth) {
  const bool fits = greatest_range >= RangeBins::kLeastReach && greatest_range <= RangeBins::kBins * depth;
  return fits ? "" : unfit("greatest_range_m is not in [10000, 64 depth_m]", greatest_range);
}

std::string problemOf(const RadarCounts& counts) {
  std::string problem = problemOfCells(counts.false_plots, problemOfFalsePlots);
  if (problem.empty()) problem = problemOfCells(counts.cover, problemOfCover);
  if (problem.empty()) problem = problemOfRange(counts.greatest_range, counts.false_plots.depth);
  return problem.empty() ? "" : "what was learned of radar " + counts.radar + ": " + problem;
}

}  // namespace adit_tracker
