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

void FalsePlotMap::close(int sector) {
  Cell& total = sectors_[static_cast<std::size_t>(sector)];
  all_ += {-total.plots, -total.exposure};
  total = {};
  const int last = binOf(greatest_range_);
  double from = 0.0;
  for (int bin = 0; bin <= last; ++bin) {
    const double to = std::min((bin + 1) * bins_.depth(), greatest_range_);
    Cell& cell = at(0, sector, bin);
    cell.plots *= kKept;
    cell.exposure = kKept * (cell.exposure + 0.5 * tws::kSectorWidth * (to * to - from * from));
    total += cell;
    from = to;
  }
  all_ += total;
  sumUp(sector);
  everywhere_ = std::max(kLeastFalsePlots, perScan()) / area();
}

/// The larger cells that hold those of the sector.
void FalsePlotMap::sumUp(int sector) {
  const int last = binOf(greatest_range_);
  for (int level = 1; level < kLevels; ++level) {
    const int half = 1 << (level - 1), first = (sector >> level) << level;
    for (int bin = 0; bin <= last; bin += 2 * half) {
      Cell sum;
      for (const int s : {first, first + half}) {
        for (const int b : {bin, bin + half}) sum += at(level - 1, s, b);
      }
      at(level, sector, bin) = sum;
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

double FalsePlotMap::perScan() const {
  Cell sum{kGuessScans * kFirstGuess, kGuessScans * area()};
  sum += all_;
  return area() * sum.plots / sum.exposure;
}

}  // namespace adit_tracker
