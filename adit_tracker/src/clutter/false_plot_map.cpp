#include "clutter/false_plot_map.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace adit_tracker {
namespace {

constexpr double kFirstGuess = 5.0;       // false plots a scan, before any have shown …
constexpr double kGuessScans = 0.5;       // … and how many scans that counts for
constexpr double kLeastFalsePlots = 0.5;  // a scan
constexpr double kPriorPlots = 2.0;       // weight of what a larger cell says
constexpr double kLoadedScans = 1.0;      // what was saved counts for: what has changed shows in two or three

}  // namespace

FalsePlotMap::FalsePlotMap()
    : greatest_range_(RangeBins::kLeastReach), cells_(static_cast<std::size_t>(kLevels * tws::kSectors * kBins)) {}

double FalsePlotMap::area() const { return tws::kPi * greatest_range_ * greatest_range_; }

void FalsePlotMap::addRange(double range) {
  greatest_range_ = std::max(greatest_range_, range);
  while (greatest_range_ > bins_.reach()) widen();
}

void FalsePlotMap::widen() {
  bins_.doubleDepth();
  for (int sector = 0; sector < tws::kSectors; ++sector) RangeBins::sumUp(&at(0, sector, 0));
  std::fill(cells_.begin() + static_cast<std::ptrdiff_t>(indexOf(1, 0, 0)), cells_.end(), Cell{});
  for (int sector = 0; sector < tws::kSectors; ++sector) sumUp(sector);
}

void FalsePlotMap::add(int sector, double range, double chance) { at(0, sector, binOf(range)).plots += chance; }

double FalsePlotMap::areaOf(int bin) const {
  const double from = bin * bins_.depth(), to = std::min((bin + 1) * bins_.depth(), greatest_range_);
  return std::max(0.0, 0.5 * tws::kSectorWidth * (to * to - from * from));
}

void FalsePlotMap::close(int sector) {
  const int last = binOf(greatest_range_);
  Cell* const cells = &at(0, sector, 0);
  for (int bin = 0; bin <= last; ++bin) {
    cells[bin].plots *= kKept;
    cells[bin].exposure = kKept * (cells[bin].exposure + areaOf(bin));
  }
  total(sector);
}

/// What the cells of a sector hold is summed up.
void FalsePlotMap::total(int sector) {
  Cell& total = sectors_[static_cast<std::size_t>(sector)];
  all_ += {-total.plots, -total.exposure};
  total = {};
  const int last = binOf(greatest_range_);
  for (int bin = 0; bin <= last; ++bin) total += at(0, sector, bin);
  all_ += total;
  sumUp(sector);
  everywhere_ = std::max(kLeastFalsePlots, perScan()) / area();
}

/// The larger cells that hold those of the sector.
void FalsePlotMap::sumUp(int sector) {
  const int last = binOf(greatest_range_);
  for (int level = 1; level < kLevels; ++level) {
    const int half = 1 << (level - 1), first = (sector >> level) << level;
    const Cell* const left = &at(level - 1, first, 0);
    const Cell* const right = &at(level - 1, first + half, 0);
    Cell* const sums = &at(level, sector, 0);
    const std::ptrdiff_t end = (last >> level) + 1;
    for (std::ptrdiff_t i = 0; i < end; ++i) {
      Cell sum = left[2 * i];
      sum += left[2 * i + 1];
      sum += right[2 * i];
      sum += right[2 * i + 1];
      sums[i] = sum;
    }
  }
}

/// From the largest cell to the smallest, each the prior of the next. What is left out stays in the smallest: counted
/// in all of them, one plot would be evidence five times over; counted in none, dense places would look thin to all
/// tracks that false plots have started.
double FalsePlotMap::estimate(int sector, int bin, double left_out) const {
  double density = everywhere_;
  if (bin > binOf(greatest_range_)) return density;
  for (int level = kLevels - 1; level >= 0; --level) {
    const Cell& cell = cells_[indexOf(level, sector, bin)];
    const double plots = std::max(0.0, cell.plots - (level > 0 ? left_out : 0.0));
    density = (plots + kPriorPlots) / (cell.exposure + kPriorPlots / density);
  }
  return density;
}

double FalsePlotMap::densityAround(double plots, double density, double range, double azimuth) const {
  if (plots == 0.0 || areMany(density)) return density;
  const int sector = tws::sectorOf(azimuth);
  return isNew(sector) ? density : estimate(sector, binOf(range), plots);
}

double FalsePlotMap::density(double range, double azimuth) const {
  const int sector = tws::sectorOf(azimuth);
  return isNew(sector) ? perScan() / area() : estimate(sector, binOf(range), 0.0);
}

void FalsePlotMap::save(RadarCounts& counts) const {
  counts.greatest_range = greatest_range_;
  counts.false_plots.depth = bins_.depth();
  for (int sector = 0; sector < tws::kSectors; ++sector) {
    for (int bin = 0; bin < kBins; ++bin) {
      const Cell& cell = cells_[indexOf(0, sector, bin)];
      const double area = areaOf(bin);
      if (area > 0.0)
        counts.false_plots.at(sector, bin) = {static_cast<float>(cell.plots), static_cast<float>(cell.exposure / area)};
    }
  }
}

/// A map that has shown just that.
FalsePlotMap FalsePlotMap::mapOf(const RadarCounts& counts) {
  FalsePlotMap map;
  map.bins_ = RangeBins(counts.false_plots.depth);
  map.greatest_range_ = counts.greatest_range;
  for (int sector = 0; sector < tws::kSectors; ++sector) {
    for (int bin = 0; bin < kBins; ++bin) {
      const CellCount& cell = counts.false_plots.at(sector, bin);
      const double exposure = static_cast<double>(cell.looks) * map.areaOf(bin);
      if (exposure > 0.0) map.at(0, sector, bin) = {static_cast<double>(cell.count), exposure};
    }
  }
  return map;
}

void FalsePlotMap::load(const RadarCounts& counts) {
  FalsePlotMap loaded = mapOf(counts);
  while (loaded.bins_.depth() < bins_.depth()) loaded.widen();
  while (bins_.depth() < loaded.bins_.depth()) widen();
  greatest_range_ = std::max(greatest_range_, loaded.greatest_range_);
  for (int sector = 0; sector < tws::kSectors; ++sector) {
    for (int bin = 0; bin <= binOf(greatest_range_); ++bin) topUp(sector, bin, loaded.at(0, sector, bin));
    total(sector);
  }
}

void FalsePlotMap::topUp(int sector, int bin, const Cell& loaded) {
  if (loaded.exposure == 0.0) return;
  Cell& cell = at(0, sector, bin);
  const double share = std::clamp((kLoadedScans * areaOf(bin) - cell.exposure) / loaded.exposure, 0.0, 1.0);
  cell += {share * loaded.plots, share * loaded.exposure};
}

double FalsePlotMap::perScan() const {
  Cell sum{kGuessScans * kFirstGuess, kGuessScans * area()};
  sum += all_;
  return area() * sum.plots / sum.exposure;
}

}  // namespace adit_tracker
