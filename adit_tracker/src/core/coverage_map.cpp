#include "core/coverage_map.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace adit_tracker {
namespace {

constexpr double kFirstGuess = 0.85;            // chance of detection before anything has shown
constexpr double kPriorLooks = 3.0;             // weight of what a larger cell says
constexpr double kPriorOfRange = 4.0;           // weight of what the range before says
constexpr float kRemembered = 64.0F;            // looks, in each smallest cell
constexpr float kSaid[] = {4.0F, 8.0F, 16.0F};  // looks, at most, that a cell says to the larger one
// Of a cell, that what was saved counts for at most. Fewer detections than misses: the first show at once that it is
// wrong.
constexpr float kLoadedLooks = 24.0F, kLoadedSeen = 4.0F;
constexpr double kEverywhereGain = 0.03;
constexpr double kGood = 0.5;   // of all looks: a radar that is on sees so many targets
constexpr double kBlind = 0.2;  // chance of detection

}  // namespace

CoverageMap::CoverageMap()
    : everywhere_(kFirstGuess), cells_(static_cast<std::size_t>(kLevels * tws::kSectors * (kBins + 1))) {}

/// What lay beyond has yet to show.
void CoverageMap::widen() {
  bins_.doubleDepth();
  outside_ = 0;
  for (auto& plots : false_plots_) RangeBins::sumUp(plots.data());
  if (!has_looked_) return;  // all cells are empty
  for (int sector = 0; sector < tws::kSectors; ++sector) {
    Cell* const bins = &cells_[indexOf(0, sector, 0)];
    RangeBins::sumUp(bins);
    bins[kBins] = {};
  }
  sumUp();
}

void CoverageMap::sumUp() {
  for (int sector = 0; sector < tws::kSectors; ++sector) {
    for (int bin = 0; bin <= kBins; ++bin) sumUp(sector, bin);
  }
}

void CoverageMap::look(double range, double azimuth, double seen, double weight) {
  const double counts = weight * (seen + (1.0 - seen) * std::min(1.0, everywhere_ / kGood));
  has_looked_ = true;
  everywhere_ += kEverywhereGain * weight * (seen - everywhere_);
  const int sector = tws::sectorOf(azimuth), bin = bins_.binOf(range);
  Cell& cell = cells_[indexOf(0, sector, bin)];
  const float kept = kRemembered / (kRemembered + static_cast<float>(counts));
  cell.seen = kept * (cell.seen + static_cast<float>(counts * seen));
  cell.looks = kept * (cell.looks + static_cast<float>(counts));
  sumUp(sector, bin);
}

CoverageMap::Cell CoverageMap::saidBy(int level, int sector, int bin) const {
  return at(level, sector, bin).atMost(kSaid[level]);
}

/// The larger cells that hold a cell.
void CoverageMap::sumUp(int sector, int bin) {
  for (int level = 1; level < kLevels; ++level) {
    const int width = 1 << (2 * (level - 1)), first = sector / (4 * width) * (4 * width);
    Cell sum;
    for (int part = 0; part < 4; ++part) sum += saidBy(level - 1, first + part * width, bin);
    cells_[indexOf(level, sector, bin)] = sum;
  }
}

double CoverageMap::after(const Cell& cell, double prior, double weight) {
  return (static_cast<double>(cell.seen) + weight * prior) / (static_cast<double>(cell.looks) + weight);
}

/// What a range has to show is expected of those beyond it, as far as they have shown nothing themselves.
double CoverageMap::priorOf(int bin) const {
  constexpr float kPlenty = 16.0F;
  const auto ring = [&](int b) -> const Cell& { return at(kLevels - 1, 0, b); };
  int first = bin;
  while (first > 0 && ring(first).looks < kPlenty) --first;
  double chance = kFirstGuess;
  for (int b = first; b < bin; ++b) chance = after(ring(b), chance, kPriorOfRange);
  return chance;
}

/// From the largest cell to the smallest. What a smaller one has said to a larger one is its own word, and comes last.
double CoverageMap::detection(double range, double azimuth) const {
  const int sector = tws::sectorOf(azimuth), bin = bins_.binOf(range);
  double chance = priorOf(bin);
  for (int level = kLevels - 1; level > 0; --level) {
    const Cell others = at(level, sector, bin).without(saidBy(level - 1, sector, bin));
    chance = after(others, chance, kPriorLooks);
  }
  return after(at(0, sector, bin), chance, kPriorLooks);
}

void CoverageMap::addPlot(double range, double azimuth, double chance_false) {
  constexpr int kSome = 3;  // plots from beyond: a single one may be mad
  if (range >= bins_.reach() && ++outside_ < kSome) return;
  while (range >= bins_.reach()) widen();
  farthest_ = std::max(farthest_, range);
  if (chance_false > 0.5) farthest_false_ = std::max(farthest_false_, range);
  const auto quadrant = static_cast<std::size_t>(tws::sectorOf(azimuth) * kQuadrants / tws::kSectors);
  false_plots_[quadrant][static_cast<std::size_t>(bins_.binOf(range))] += chance_false;
}

/// False plots come from just within the farthest plot, in all quadrants, and none from beyond it, where so many were
/// to be expected. Where tracks come from farther than false plots do, that shows nothing.
bool CoverageMap::isBeyond(double range) const {
  constexpr double kEnough = 3.0, kEdge = 0.9, kNearly = 0.99;
  if (range <= farthest_ || farthest_false_ < kNearly * farthest_) return false;
  const int first = bins_.binOf(kEdge * farthest_), last = std::min(bins_.binOf(farthest_), kBins - 1);
  double plots = std::numeric_limits<double>::infinity();
  for (const auto& quadrant : false_plots_) {
    const auto begin = quadrant.begin();
    plots = std::min(plots, kQuadrants * std::accumulate(begin + first, begin + last + 1, 0.0));
  }
  const double from = first * bins_.depth(), outside = range * range - farthest_ * farthest_;
  return plots * outside > kEnough * (farthest_ * farthest_ - from * from);
}

void CoverageMap::save(RadarCounts& counts) const {
  counts.cover.depth = bins_.depth();
  for (int sector = 0; sector < tws::kSectors; ++sector) {
    for (int bin = 0; bin <= kBins; ++bin) {
      const Cell& cell = at(0, sector, bin);
      counts.cover.at(sector, bin) = {cell.seen, cell.looks};
    }
  }
}

void CoverageMap::load(const RadarCounts& counts) {
  CoverageMap loaded;
  loaded.bins_ = RangeBins(counts.cover.depth);
  loaded.has_looked_ = true;
  for (int sector = 0; sector < tws::kSectors; ++sector) {
    for (int bin = 0; bin <= kBins; ++bin) {
      const CellCount& cell = counts.cover.at(sector, bin);
      loaded.cells_[indexOf(0, sector, bin)] = {cell.count, cell.looks};
    }
  }
  while (loaded.bins_.depth() < bins_.depth()) loaded.widen();
  while (bins_.depth() < loaded.bins_.depth()) widen();
  for (std::size_t i = 0; i < indexOf(1, 0, 0); ++i) {
    topUp(cells_[i], loaded.cells_[i]);
    has_looked_ = has_looked_ || cells_[i].looks > 0.0F;
  }
  sumUp();
}

void CoverageMap::topUp(Cell& cell, const Cell& loaded) {
  if (loaded.looks <= 0.0F) return;
  float share = std::clamp((kLoadedLooks - cell.looks) / loaded.looks, 0.0F, 1.0F);
  if (loaded.seen > 0.0F) share = std::min(share, std::max(0.0F, (kLoadedSeen - cell.seen) / loaded.seen));
  cell += {share * loaded.seen, share * loaded.looks};
}

bool CoverageMap::isBlind(double range, double azimuth) const {
  return isBeyond(range) || (has_looked_ && detection(range, azimuth) < kBlind);
}

}  // namespace adit_tracker
