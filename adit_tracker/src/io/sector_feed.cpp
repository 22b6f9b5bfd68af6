#include "io/sector_feed.h"

#include <cmath>

#include <tws_core/sectors.h>

namespace adit_tracker {

SectorFeed::SectorFeed(std::vector<tws::Plot> plots, tws::Rotation rotation)
    : plots_(std::move(plots)), rotation_(std::move(rotation)) {
  const double first = rotation_.unwrappedAt(plots_.front().time);
  whole_turns_ = static_cast<std::int64_t>(std::floor(first / tws::kTwoPi));
  running_ = static_cast<std::int64_t>(std::floor(first / tws::kSectorWidth)) - whole_turns_ * tws::kSectors;
  enter_time_ = start(running_);
}

double SectorFeed::start(std::int64_t running) const {
  return rotation_.timeAt(static_cast<double>(running + whole_turns_ * tws::kSectors) * tws::kSectorWidth);
}

std::optional<double> SectorFeed::nextTime() const {
  if (next_ >= plots_.size()) return std::nullopt;
  return start(running_ + 1);
}

tws::RadarSector SectorFeed::take() {
  tws::RadarSector sector;
  sector.running = running_;
  sector.sector = static_cast<int>(running_ % tws::kSectors);
  sector.enter_time = enter_time_;
  sector.leave_time = start(++running_);
  enter_time_ = sector.leave_time;
  while (next_ < plots_.size() && plots_[next_].time < sector.leave_time) sector.plots.push_back(plots_[next_++]);
  leap();
  return sector;
}

// Over a break of the rotation, whose sectors take no time, and one turn more, so that nobody measures the period
// across it.
void SectorFeed::leap() {
  const double normal = rotation_.period() / tws::kSectors;
  if (rotation_.breaks().empty() || start(running_ + 1) - start(running_) > normal / 4.0) return;
  while (start(running_ + 1) - start(running_) < normal / 4.0) ++running_;
  enter_time_ = start(running_);
  running_ += tws::kSectors;
  whole_turns_ -= 1;
}

}  // namespace adit_tracker
