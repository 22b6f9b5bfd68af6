#include "track_census.h"

#include <tws_msgs/Track.h>

#include <algorithm>

namespace tws_launch {

using tws_msgs::Track;

void TrackCensus::add(std::uint32_t uid, std::uint8_t state) {
  if (state == Track::DROPPED) {
    living_.erase(uid);
    ++ended_;
    return;
  }
  Living& track = living_[uid];
  track.state = state;
  if (state != Track::FIRM || track.was_firm) return;
  track.was_firm = true;
  ++ever_firm_;
}

void TrackCensus::beginNewRun() {
  ended_ += living_.size();
  living_.clear();
}

std::size_t TrackCensus::count(std::uint8_t state) const {
  return static_cast<std::size_t>(
      std::count_if(living_.begin(), living_.end(), [&](const auto& track) { return track.second.state == state; }));
}

}  // namespace tws_launch
