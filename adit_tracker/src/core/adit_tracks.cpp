// How Adit starts tracks, and ends them by hand.
#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

#include "core/adit.h"

namespace adit_tracker {

std::optional<TrackFile::Slot> Adit::newTrack(std::size_t radar, const tws::Plot& plot) {
  const auto slot = tracks_.start();
  if (!slot) {
    ++counts_.refused_tracks;
    return std::nullopt;
  }
  Track& track = tracks_.at(*slot);
  motion_.start(track, plot, radars_[radar].quality, radar);
  judge_.started(track, radars_[radar].quality);
  heights_.update(track.uid, plot);
  track.apart = plot.time;
  if (sites_.size() > 1) doubtOtherSites(track, radar);
  const bool elsewhere = motion_.joined();
  if (params_.conversion.from_start) {
    track.reference = {plot.time, elsewhere ? track.smoothed.range : plot.range,
                       elsewhere ? track.smoothed.azimuth : plot.azimuth};
  }
  ++counts_.tracks_started;
  return slot;
}

Track* Adit::startTrack(std::size_t radar, const tws::Plot& plot) {
  const auto slot = newTrack(radar, plot);
  if (!slot) return nullptr;
  Track& track = tracks_.at(*slot);
  track.updated[radar] = plot.time;
  // Met in a sector that is behind the front or at most a few ahead of it.
  track.illuminated[radar] = tws::Antenna::near(plot.azimuth, order_.front(radar));
  track.detected_by = static_cast<std::uint16_t>(1U << radar);
  enterSectors(*slot, radars_[radar].site);
  report_.words.push_back({*slot, TrackEvent::kStarted, plot.time});
  return &track;
}

void Adit::startTrackOrBranch(const tws::SectorRef& turn, const Detection& detection) {
  RadarState& radar = radarOf(turn);
  const auto parting = params_.bifurcation ? bifurcation_.partingOf(tracks_, detection, radar, turn) : std::nullopt;
  Track* const track = startTrack(turn.radar, detection.plot);
  if (track == nullptr || !parting) return;
  const Track& parent = tracks_.at(parting->parent);
  motion_.branch(*track, parent, *parting, turn.radar);
  track->parent = parent.uid;
  track->existence = track->first_existence = static_cast<float>(parting->chance);
  predictNext(*track, radar.site);
}

std::optional<TrackFile::Slot> Adit::startByHand(double range, double azimuth, double sigma) {
  constexpr float kOperatorsWord = 0.9F;  // the chance that there is something where an operator says so
  tws::Plot point;
  point.time = report_.enter_time;
  point.range = range;
  point.azimuth = tws::wrapTwoPi(azimuth);
  point.range_sigma = sigma;
  point.azimuth_sigma = std::min(sigma / range, tws::kSectorWidth);
  const auto slot = newTrack(report_.radar, point);
  if (!slot) return std::nullopt;
  Track& track = tracks_.at(*slot);
  track.existence = track.first_existence = kOperatorsWord;
  if (motion_.joined()) motion_.relocate(track, range * std::sin(azimuth), range * std::cos(azimuth));
  motion_.predict(track, report_.radar, point.time, radars_[report_.radar].quality);
  enterSectors(*slot, radars_[report_.radar].site);
  by_hand_.push_back({*slot, TrackEvent::kStarted, point.time});
  return slot;
}

void Adit::dropByHand(TrackFile::Slot slot) {
  tracks_.withdraw(slot);
  by_hand_.push_back({slot, TrackEvent::kDropped, report_.enter_time});
  ++counts_.tracks_dropped;
}

std::optional<TrackFile::Slot> Adit::find(std::uint32_t number) const {
  for (const auto slot : living()) {
    if (tracks_.at(slot).number == number) return slot;
  }
  return std::nullopt;
}

std::vector<TrackFile::Slot> Adit::living() const {
  Slots all;
  for (int sector = 0; sector < tws::kSectors; ++sector) tracks_.list(sector, all);
  return all;
}

}  // namespace adit_tracker
