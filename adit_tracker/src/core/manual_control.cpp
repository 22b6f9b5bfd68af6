#include "core/manual_control.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace adit_tracker {

std::optional<TrackFile::Slot> ManualControl::start(double range, double azimuth, double sigma) {
  constexpr float kOperatorIsRight = 0.9F;  // the chance that there is something where an operator says so
  const SectorReport& latest = tracks_.latest();
  tws::Plot point;
  point.time = latest.enter_time;
  point.range = range;
  point.azimuth = tws::wrapTwoPi(azimuth);
  point.range_sigma = sigma;
  point.azimuth_sigma = std::min(sigma / range, tws::kSectorWidth);
  const auto slot = tracks_.create(latest.radar, point);
  if (!slot) return std::nullopt;
  Track& track = tracks_.at(*slot);
  track.existence = track.first_existence = kOperatorIsRight;
  const TrackMotion& motion = tracks_.motion();
  if (motion.joined()) motion.relocate(track, range * std::sin(azimuth), range * std::cos(azimuth));
  motion.predict(track, latest.radar, point.time, radars_.quality(latest.radar));
  meeting_.enter(*slot, radars_.at(latest.radar).site);
  tracks_.reportByHand(*slot, TrackEvent::kStarted);
  return slot;
}

std::size_t ManualControl::load(const SavedMaps& maps) {
  radars_.check(maps.radars);
  const std::size_t refused = clutter_.load(maps.clutter, tracks_.latest().enter_time);
  radars_.load(maps.radars);
  return refused;
}

}  // namespace adit_tracker
