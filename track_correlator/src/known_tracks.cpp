#include "known_tracks.h"

#include <algorithm>

#include <tws_core/geometry.h>
#include <tws_core/sectors.h>

namespace track_correlator {
namespace {

constexpr int kAhead = 1, kBehind = 2;  // [sectors]

}  // namespace

Eigen::Vector4d KnownTrack::at(double time) const {
  Eigen::Vector4d now = input.state;
  now.head<2>() += (time - input.time) * input.state.tail<2>();
  return now;
}

bool KnownTrack::isFresh(std::int64_t running) const { return running - done >= tws::kHalfTurn; }

bool KnownTrack::isDue(std::int64_t running) const { return behind >= 0 && behind <= kBehind && isFresh(running); }

void KnownTracks::add(const TrackInput& track) {
  KnownTrack& known = tracks_[track.uid];
  known.input = track;
  known.next_look = KnownTrack::kNever;
  oldest_ = std::min(oldest_, track.time);
}

KnownTrack* KnownTracks::find(std::uint32_t uid) {
  const auto found = tracks_.find(uid);
  return found == tracks_.end() ? nullptr : &found->second;
}

void KnownTracks::restart(std::int64_t running) {
  for (auto& [uid, track] : tracks_) {
    track.done = track.taken = running - tws::kSectors;
    track.next_look = KnownTrack::kNever;
  }
}

std::vector<std::uint32_t> KnownTracks::silentAt(double time, double timeout) {
  std::vector<std::uint32_t> silent;
  if (time - oldest_ <= timeout) return silent;
  oldest_ = std::numeric_limits<double>::infinity();
  for (const auto& [uid, track] : tracks_) {
    oldest_ = std::min(oldest_, track.input.time);
    if (time - track.input.time > timeout) silent.push_back(uid);
  }
  return silent;
}

const KnownTracks::Near& KnownTracks::nearTo(const Mark& mark) {
  const int sector = static_cast<int>(mark.running % tws::kSectors);
  near_.clear();
  for (auto& [uid, track] : tracks_) {
    if (track.next_look > mark.running) continue;
    track.behind = tws::sectorDifference(sector, tws::sectorOf(tws::azimuthOf(track.at(mark.time).head<2>())));
    if (track.behind >= -kAhead && track.behind <= kBehind) {
      near_.emplace_back(uid, &track);
      continue;
    }
    // The beam is so many sectors away; the track may come half of the way towards it.
    const int away = track.behind < 0 ? -track.behind - kAhead : tws::kSectors - track.behind - kAhead;
    track.next_look = mark.running + std::max(1, away / 2);
  }
  return near_;
}

}  // namespace track_correlator
