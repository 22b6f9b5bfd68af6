#include "core/north_sectors.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <tws_core/antenna.h>
#include <tws_core/sectors.h>

namespace adit_tracker {

/// Headings go on beyond a whole turn; the first one is positive, and a whole turn more, so that numbers are.
double NorthSectors::unwrap(double heading) {
  heading_ =
      has_heading_ ? heading_ + tws::angularDifference(heading, heading_) : tws::wrapTwoPi(heading) + tws::kTwoPi;
  has_heading_ = true;
  return heading_;
}

void NorthSectors::open(std::int64_t running, double time) {
  tws::RadarSector& sector = open_.emplace();
  sector.running = std::max(running, next_);
  sector.sector = tws::Antenna::sectorNumber(sector.running);
  sector.enter_time = time;
  next_ = sector.running + 1;
}

tws::RadarSector NorthSectors::close(double time) {
  tws::RadarSector sector = std::move(*open_);
  open_.reset();
  sector.leave_time = time;
  return sector;
}

std::vector<tws::RadarSector> NorthSectors::add(const tws::RadarSector& sector, const Passage& ship) {
  std::vector<tws::RadarSector> left;
  const double begin = tws::Antenna::startOf(sector.running) + unwrap(ship.from.heading);
  const double end = tws::Antenna::startOf(sector.running + 1) + unwrap(ship.to.heading);
  if (open_ && sector.running != before_ + 1) left.push_back(close(end_));
  before_ = sector.running;
  end_ = sector.leave_time;
  if (!open_) open(static_cast<std::int64_t>(std::floor(begin / tws::kSectorWidth)), sector.enter_time);
  auto plot = sector.plots.begin();
  const auto last = static_cast<std::int64_t>(std::floor(end / tws::kSectorWidth));
  while (open_->running < last) {
    const double border = tws::Antenna::startOf(open_->running + 1);
    const double time = sector.enter_time + std::clamp((border - begin) / (end - begin), 0.0, 1.0) *
                                                (sector.leave_time - sector.enter_time);
    for (; plot != sector.plots.end() && plot->time < time; ++plot) open_->plots.push_back(*plot);
    const std::int64_t next = open_->running + 1;
    left.push_back(close(time));
    open(next, time);
  }
  open_->plots.insert(open_->plots.end(), plot, sector.plots.end());
  return left;
}

std::optional<tws::RadarSector> NorthSectors::finish() {
  if (!open_) return std::nullopt;
  return close(end_);
}

}  // namespace adit_tracker
