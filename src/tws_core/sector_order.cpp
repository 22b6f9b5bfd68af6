#include <tws_core/sector_order.h>

#include <algorithm>

namespace tws {

SectorOrder::SectorOrder(std::size_t radars, double limit, std::int64_t ahead)
    : radars_(radars), limit_(limit), ahead_(ahead) {}

bool SectorOrder::add(const SectorRef& sector, double enter_time, double leave_time) {
  Radar& radar = radars_[sector.radar];
  if (!any_) first_ = enter_time;
  any_ = true;
  radar.pending.push_back({sector.running, enter_time, leave_time});
  radar.newest = sector.running;
  radar.newest_leave = leave_time;
  radar.sector_duration = leave_time - enter_time;
  radar.known = true;
  newest_ = std::max(newest_, leave_time);
  return !(any_handed_out_ && enter_time < handed_out_);
}

bool SectorOrder::overdue(const Radar& radar) const {
  return newest_ > (radar.known ? radar.newest_leave + radar.sector_duration : first_) + limit_;
}

double SectorOrder::nextTime(const Radar& radar) const {
  return radar.pending.empty() ? radar.newest_leave : radar.pending.front().enter_time;
}

/// The sectors ahead are closed, or nothing more will come of this radar.
bool SectorOrder::complete(const Radar& radar) const {
  return finished_ || radar.pending.front().running + ahead_ <= radar.newest || overdue(radar);
}

/// Can the radar no longer come up with a sector older than `time`: it has passed that time, or is silent?
bool SectorOrder::cannotPrecede(const Radar& radar, double time) const {
  if (finished_ && radar.pending.empty()) return true;
  if (!radar.known) return newest_ > std::max(time, first_) + limit_;
  if (nextTime(radar) > time) return true;
  return radar.pending.empty() && newest_ > std::max(time, radar.newest_leave) + radar.sector_duration + limit_;
}

/// The radar whose next sector was crossed first; of two crossed at the same instant the first radar's.
std::optional<std::size_t> SectorOrder::earliest() const {
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < radars_.size(); ++i) {
    if (!radars_[i].pending.empty() && (!best || nextTime(radars_[i]) < nextTime(radars_[*best]))) best = i;
  }
  return best;
}

/// Must the radar with the earliest sector wait for this one?
bool SectorOrder::holdsUp(std::size_t radar, std::size_t earliest) const {
  const double time = nextTime(radars_[earliest]);
  const bool goes_second = radar > earliest && nextTime(radars_[radar]) == time && radars_[radar].known;
  return radar != earliest && !goes_second && !cannotPrecede(radars_[radar], time);
}

std::optional<SectorRef> SectorOrder::next() {
  const auto best = earliest();
  if (!best || !complete(radars_[*best])) return std::nullopt;
  for (std::size_t i = 0; i < radars_.size(); ++i) {
    if (holdsUp(i, *best)) return std::nullopt;
  }
  Radar& radar = radars_[*best];
  const Pending sector = radar.pending.front();
  radar.next = sector.running + 1;
  radar.done_until = sector.leave_time;
  radar.pending.pop_front();
  handed_out_ = std::max(handed_out_, sector.enter_time);
  any_handed_out_ = true;
  return SectorRef{*best, sector.running};
}

std::vector<std::size_t> SectorOrder::ready() const {
  std::vector<std::size_t> sectors(radars_.size(), 0);
  for (SectorOrder ahead = *this; const auto sector = ahead.next();) ++sectors[sector->radar];
  return sectors;
}

std::size_t SectorOrder::waiting() const {
  std::size_t sectors = 0;
  for (const Radar& radar : radars_) sectors += radar.pending.size();
  return sectors;
}

}  // namespace tws
