// How Adit starts tracks, ends them by hand, and finds where a beam meets them next.
#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

#include "adit.h"

namespace adit_tracker {
namespace {

// A prediction that is off by less in time is not made anew.
constexpr double kPredictionTolerance = 0.3;  // [s]

}  // namespace

std::optional<TrackFile::Slot> Adit::newTrack(std::size_t radar, const tws::Plot& plot) {
  const auto slot = tracks_.start();
  if (!slot) {
    ++counts_.refused_tracks;
    return std::nullopt;
  }
  Track& track = tracks_.at(*slot);
  motion_.start(track, plot, radars_[radar].quality);
  judge_.started(track, radars_[radar].quality);
  if (params_.conversion.from_start) track.reference = {plot.time, plot.range, plot.azimuth};
  ++counts_.tracks_started;
  return slot;
}

Track* Adit::startTrack(std::size_t radar, const tws::Plot& plot) {
  const auto slot = newTrack(radar, plot);
  if (!slot) return nullptr;
  Track& track = tracks_.at(*slot);
  track.updated[radar] = plot.time;
  // Met in a sector that is behind the front or at most a few ahead of it.
  track.illuminated[radar] = Antenna::near(plot.azimuth, executive_.front(radar));
  track.detected_by = static_cast<std::uint16_t>(1U << radar);
  predictNext(track);
  tracks_.place(*slot, tws::sectorOf(track.predicted.azimuth));
  report_.words.push_back({*slot, TrackEvent::kStarted, plot.time});
  return &track;
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
  motion_.predict(track, report_.radar, point.time, radars_[report_.radar].quality);
  predictNext(track);
  tracks_.place(*slot, tws::sectorOf(track.predicted.azimuth));
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

/// Updated or missed: a track that has moved on into the next sector has had its chance all the same.
bool Adit::metOnThisScan(const Track& track, std::size_t radar, std::int64_t running) {
  return track.illuminated[radar] > Antenna::startOf(running) - tws::kPi;
}

/// Sees to it that the prediction is for this radar's beam in that sector. It mostly is already; not so when another
/// radar, which should have come first, is silent.
void Adit::aimAt(Track& track, std::size_t radar, std::int64_t running) {
  const double time = radars_[radar].antenna.timeAt(Antenna::near(track.predicted.azimuth, running));
  if (track.predicted.radar == radar && std::abs(time - track.predicted.time) < kPredictionTolerance) return;
  motion_.predict(track, radar, time, radars_[radar].quality);
}

/// Puts the track into the sector where its next illumination will be.
void Adit::moveOn(TrackFile::Slot slot, std::size_t radar) {
  if (!dropped_.empty() && std::find(dropped_.begin(), dropped_.end(), slot) != dropped_.end()) return;
  const int from = tracks_.sector(slot);
  int to = tws::sectorOf(tracks_.at(slot).predicted.azimuth);
  for (std::size_t other = 0; other < radars_.size(); ++other) {
    if (other != radar && from != to && wouldMissUpdate(from, to, other)) to = from;
  }
  tracks_.place(slot, to);
}

/// Has the other radar's processing passed the new sector, but not the old one? Then the track stays where it is.
bool Adit::wouldMissUpdate(int from, int to, std::size_t radar) const {
  if (!radars_[radar].antenna.known() || executive_.silent(radar)) return false;
  const int front = Antenna::sectorNumber(executive_.front(radar));
  return tws::sectorDifference(from, front) >= 0 && tws::sectorDifference(to, front) < 0 &&
         std::abs(tws::sectorDifference(to, from)) < tws::kSectors / 4;
}

/// When the beam of a radar meets the track next, in a sector that is still to be processed [s].
double Adit::nextIllumination(const Track& track, std::size_t radar) const {
  const Antenna& antenna = radars_[radar].antenna;
  const double earliest = std::max(Antenna::startOf(executive_.front(radar)), track.illuminated[radar] + tws::kPi);
  const auto atLeast = [&](double azimuth) { return earliest + tws::wrapTwoPi(azimuth - earliest); };
  const double guess = atLeast(track.smoothed.azimuth);
  // Right over the site, azimuth rates have no meaning: half a turn at most.
  const double moved =
      std::clamp(track.smoothed.azimuth_rate * (antenna.timeAt(guess) - track.smoothed.time), -tws::kPi, tws::kPi);
  double crossing = guess + moved;
  if (crossing < earliest) crossing += tws::kTwoPi;
  return antenna.timeAt(crossing);
}

/// T2 of the report: the earliest next time that any radar will illuminate the track.
void Adit::predictNext(Track& track) {
  std::size_t next = radars_.size();
  double earliest = 0.0;
  for (std::size_t radar = 0; radar < radars_.size(); ++radar) {
    if (!radars_[radar].antenna.known() || executive_.silent(radar)) continue;
    const double time = nextIllumination(track, radar);
    if (next < radars_.size() && time >= earliest) continue;
    next = radar;
    earliest = time;
  }
  if (next == radars_.size()) return;  // all radars are silent: the sectors still in hand are the last
  motion_.predict(track, next, earliest, radars_[next].quality);
}

std::vector<TrackFile::Slot> Adit::living() const {
  Slots all;
  for (int sector = 0; sector < tws::kSectors; ++sector) tracks_.list(sector, all);
  return all;
}

}  // namespace adit_tracker
