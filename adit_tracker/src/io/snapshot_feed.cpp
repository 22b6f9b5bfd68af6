#include "io/snapshot_feed.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/instant.h>
#include <tws_core/median.h>
#include <tws_core/sectors.h>
#include <tws_core/units.h>

#include "io/scan_motion.h"

namespace adit_tracker {
namespace {

using Azimuths = std::vector<double>;  // of one instant, sorted [rad]

constexpr double kShortest = 0.5;  // between two snapshots [s]
constexpr std::size_t kFewestInstants = 3;
constexpr std::size_t kMostInstants = 200;  // that are looked at
constexpr std::size_t kLags = 10;           // instants over which targets are still about where they were
constexpr double kSameDirection = tws::radians(20.0);

struct Instants {
  std::vector<double> times;
  std::vector<Azimuths> azimuths;
};

Instants instantsOf(const std::vector<tws::Plot>& plots) {
  Instants instants;
  for (auto first = plots.begin(); first != plots.end() && instants.times.size() < kMostInstants;) {
    const auto last = tws::endOfInstant(first, plots.end());
    instants.times.push_back(first->time);
    Azimuths& azimuths = instants.azimuths.emplace_back();
    for (; first != last; ++first) azimuths.push_back(first->azimuth);
    std::sort(azimuths.begin(), azimuths.end());
  }
  return instants;
}

double distanceTo(const Azimuths& azimuths, double azimuth) {
  const auto after = std::lower_bound(azimuths.begin(), azimuths.end(), azimuth);
  const double next = after == azimuths.end() ? azimuths.front() : *after;
  const double before = after == azimuths.begin() ? azimuths.back() : *std::prev(after);
  return std::min(std::abs(tws::wrapPi(next - azimuth)), std::abs(tws::wrapPi(azimuth - before)));
}

/// How far the plots of an instant are from the nearest ones in azimuth so many instants later: their median [rad].
double shiftBetween(const std::vector<Azimuths>& instants, std::size_t lag) {
  std::vector<double> distances;
  for (std::size_t i = 0; i + lag < instants.size(); ++i)
    for (const double azimuth : instants[i]) distances.push_back(distanceTo(instants[i + lag], azimuth));
  return tws::median(std::move(distances));
}

double medianStep(const std::vector<double>& times) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < times.size(); ++i) steps.push_back(times[i] - times[i - 1]);
  return tws::median(std::move(steps));
}

}  // namespace

std::optional<double> snapshotPeriod(const std::vector<tws::Plot>& plots) {
  const Instants instants = instantsOf(plots);
  const std::size_t count = instants.times.size();
  if (count < kFewestInstants || plots.size() < 2 * count) return std::nullopt;
  const double period = medianStep(instants.times);
  if (period < kShortest) return std::nullopt;
  for (std::size_t lag = 1; lag <= std::min(kLags, count - 1); ++lag)
    if (shiftBetween(instants.azimuths, lag) > kSameDirection) return std::nullopt;
  if (moveWithTheBeam(plots, period)) return std::nullopt;
  return period;
}

SnapshotFeed::SnapshotFeed(std::vector<tws::Plot> plots, double period) : plots_(std::move(plots)), period_(period) {
  nextInstant();
}

double SnapshotFeed::sectorEnd(std::int64_t sector) const {
  return instant_ - kSnapshotSweep * static_cast<double>(tws::kSectors - 1 - sector) / tws::kSectors;
}

std::optional<double> SnapshotFeed::nextTime() const {
  if (first_ >= plots_.size()) return std::nullopt;
  return sectorEnd(sector_);
}

tws::RadarSector SnapshotFeed::take() {
  tws::RadarSector sector;
  sector.running = scan_ * tws::kSectors + sector_;
  sector.sector = static_cast<int>(sector_);
  sector.enter_time = sectorEnd(sector_ - 1);
  sector.leave_time = sectorEnd(sector_);
  for (std::size_t i = first_; i < last_; ++i) {
    if (tws::sectorOf(plots_[i].azimuth) != sector.sector) continue;
    sector.plots.push_back(plots_[i]);
    sector.plots.back().time = sector.enter_time;
  }
  if (++sector_ == tws::kSectors) nextInstant();
  return sector;
}

// Scans without a plot are left out: their numbers pass, so that nobody measures the period over them.
void SnapshotFeed::nextInstant() {
  const bool is_first = last_ == 0;
  first_ = last_;
  sector_ = 0;
  if (first_ >= plots_.size()) return;
  const double before = instant_;
  const auto first = plots_.begin() + static_cast<std::ptrdiff_t>(first_);
  instant_ = first->time;
  last_ = static_cast<std::size_t>(tws::endOfInstant(first, plots_.end()) - plots_.begin());
  if (!is_first) scan_ += std::max<std::int64_t>(1, std::llround((instant_ - before) / period_));
}

}  // namespace adit_tracker
