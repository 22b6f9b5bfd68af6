#include "elevation/elevation_schedule.h"

#include <algorithm>

namespace adit_tracker {
namespace {

void moveFront(std::deque<ElevationSchedule::Uid>& from, std::size_t count, std::vector<ElevationSchedule::Uid>& to) {
  const auto end = from.begin() + static_cast<std::ptrdiff_t>(std::min(count, from.size()));
  to.insert(to.end(), from.begin(), end);
  from.erase(from.begin(), end);
}

}  // namespace

void ElevationSchedule::designate(Uid track) {
  if (counters_.emplace(track, kNew).second) new_.push_back(track);
}

void ElevationSchedule::remove(Uid track) {
  counters_.erase(track);
  for (std::deque<Uid>* list : {&new_, &waiting_})
    list->erase(std::remove(list->begin(), list->end(), track), list->end());
}

void ElevationSchedule::tried(Uid track) {
  const auto found = counters_.find(track);
  if (found == counters_.end() || found->second == kNew) return;
  if (found->second > 1) {
    --found->second;
    return;
  }
  found->second = params_.every_scans;
  if (std::find(waiting_.begin(), waiting_.end(), track) == waiting_.end()) waiting_.push_back(track);
}

std::vector<ElevationSchedule::Uid> ElevationSchedule::next() {
  const auto most = static_cast<std::size_t>(params_.per_scan);
  std::vector<Uid> searches;
  moveFront(new_, std::min(static_cast<std::size_t>(params_.new_per_scan), most), searches);
  for (const Uid track : searches) counters_[track] = params_.every_scans;
  moveFront(waiting_, most - searches.size(), searches);
  return searches;
}

std::vector<ElevationSchedule::Uid> ElevationSchedule::designated() const {
  std::vector<Uid> all;
  for (const auto& entry : counters_) all.push_back(entry.first);
  return all;
}

}  // namespace adit_tracker
