#include "core/executive.h"

#include <algorithm>

namespace adit_tracker {
Executive::Executive(std::size_t radars, double limit) : radars_(radars), limit_(limit) {}

bool Executive::closed(std::size_t radar, std::int64_t running, double enter_time, double leave_time) {
  Radar& r = radars_[radar];
  if (!any_) first_ = enter_time;
  any_ = true;
  r.pending.push_back({running, enter_time, leave_time});
  r.newest = running;
  r.newest_leave = leave_time;
  r.sector_duration = leave_time - enter_time;
  r.heard = true;
  newest_ = std::max(newest_, leave_time);
  return !(any_handed_out_ && enter_time < handed_out_);
}

bool Executive::overdue(const Radar& radar) const {
  return newest_ > (radar.heard ? radar.newest_leave + radar.sector_duration : first_) + limit_;
}

bool Executive::silent(std::size_t radar) const { return handed_out_ > radars_[radar].done_until + limit_; }

std::int64_t Executive::front(std::size_t radar) const { return radars_[radar].next; }

double Executive::nextTime(const Radar& radar) const {
  return radar.pending.empty() ? radar.newest_leave : radar.pending.front().enter_time;
}

/// The sectors ahead are closed, or nothing more will come of this radar.
bool Executive::ready(const Radar& radar) const {
  if (radar.pending.empty()) return false;
  return finished_ || radar.pending.front().running + kSectorsAhead <= radar.newest || overdue(radar);
}

/// Could `radar` still come up with a sector older than `time`?
bool Executive::mayYieldTo(const Radar& radar, double time) const {
  if (finished_ && radar.pending.empty()) return true;
  if (!radar.heard) return newest_ > std::max(time, first_) + limit_;
  if (nextTime(radar) > time) return true;
  return radar.pending.empty() && newest_ > std::max(time, radar.newest_leave) + radar.sector_duration + limit_;
}

std::optional<Executive::Turn> Executive::next() {
  std::size_t best = radars_.size();
  for (std::size_t i = 0; i < radars_.size(); ++i) {
    if (!radars_[i].pending.empty() && (best == radars_.size() || nextTime(radars_[i]) < nextTime(radars_[best])))
      best = i;
  }
  if (best == radars_.size() || !ready(radars_[best])) return std::nullopt;
  const double time = nextTime(radars_[best]);
  for (std::size_t i = 0; i < radars_.size(); ++i) {
    // Of two sectors crossed at the same instant the first radar's goes first.
    const bool tie = i > best && nextTime(radars_[i]) == time && radars_[i].heard;
    if (i != best && !tie && !mayYieldTo(radars_[i], time)) return std::nullopt;
  }
  Radar& r = radars_[best];
  const Turn turn{best, r.pending.front().running};
  r.next = turn.running + 1;
  r.done_until = r.pending.front().leave_time;
  r.pending.pop_front();
  handed_out_ = std::max(handed_out_, time);
  any_handed_out_ = true;
  return turn;
}

std::vector<std::size_t> Executive::ready() const {
  std::vector<std::size_t> sectors(radars_.size(), 0);
  for (Executive ahead = *this; const auto turn = ahead.next();) ++sectors[turn->radar];
  return sectors;
}

}  // namespace adit_tracker
