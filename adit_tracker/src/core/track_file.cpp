#include "core/track_file.h"

namespace adit_tracker {
namespace {

constexpr std::size_t kCacheLine = 64;

/// The first `bytes` of a track, and what else is in their cache lines.
void fetch(const Track& track, std::size_t bytes) {
  const char* const begin = reinterpret_cast<const char*>(&track);
  for (std::size_t i = 0; i < bytes; i += kCacheLine) __builtin_prefetch(begin + i);
}

}  // namespace

TrackFile::TrackFile(std::uint32_t capacity) : numbers_(capacity), sites_{tws::SectorFile(capacity)} {}

void TrackFile::addSite() { sites_.emplace_back(numbers_.size()); }

std::optional<TrackFile::Slot> TrackFile::start() {
  const std::optional<std::uint32_t> number = numbers_.take();
  if (!number) return std::nullopt;
  Slot slot = static_cast<Slot>(tracks_.size());
  if (free_.empty()) {
    tracks_.emplace_back();
  } else {
    slot = free_.back();
    free_.pop_back();
    tracks_[slot] = Track{};
  }
  Track& track = tracks_[slot];
  track.number = *number;
  track.uid = next_uid_++;
  track.updated.fill(kNever);
  track.illuminated.fill(kNever);
  ++size_;
  return slot;
}

void TrackFile::drop(Slot slot) {
  withdraw(slot);
  numbers_.drop(tracks_[slot].number);
  free_.push_back(slot);
  --size_;
}

void TrackFile::withdraw(Slot slot) {
  for (tws::SectorFile& sectors : sites_) {
    if (sectors.sector(slot) >= 0) sectors.remove(slot);
  }
}

void TrackFile::place(Slot slot, int sector, std::size_t site) {
  tws::SectorFile& sectors = sites_[site];
  if (sectors.sector(slot) >= 0) sectors.remove(slot);
  if (tracks_[slot].firm) {
    sectors.addFirst(slot, sector);
  } else {
    sectors.addLast(slot, sector);
  }
}

void TrackFile::list(int sector, std::vector<Slot>& slots, std::size_t site) const {
  const tws::SectorFile& sectors = sites_[site];
  for (Slot s = sectors.first(sector); s != tws::SectorFile::kNone; s = sectors.next(s)) {
    fetch(tracks_[s], sizeof(Track::predicted));
    slots.push_back(s);
  }
}

void TrackFile::fetchAhead(Slot slot) const { fetch(tracks_[slot], sizeof(Track)); }

}  // namespace adit_tracker
