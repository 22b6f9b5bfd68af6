#include "core/next_meeting.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace adit_tracker {
namespace {

// A prediction that is off by less in time is not made anew.
constexpr double kPredictionTolerance = 0.3;  // [s]

}  // namespace

/// Does the radar stand there, and is it working?
bool NextMeeting::scans(std::size_t radar, std::size_t site) const {
  return radars_.at(radar).site == site && radars_.antenna(radar).known() && !order_.silent(radar);
}

void NextMeeting::list(const tws::SectorRef& sector, Slots& slots) {
  const std::size_t begin = slots.size();
  tracks_.list(tws::Antenna::sectorNumber(sector.running), slots, radars_.at(sector.radar).site);
  const auto met = [&](TrackFile::Slot s) { return metOnThisScan(tracks_.at(s), sector); };
  slots.erase(std::remove_if(slots.begin() + static_cast<std::ptrdiff_t>(begin), slots.end(), met), slots.end());
  for (std::size_t i = begin; i < slots.size(); ++i) aimAt(tracks_.at(slots[i]), sector);
}

/// Sees to it that the prediction is for this radar's beam in that sector. It mostly is already; not so when another
/// radar, which should have come first, is silent, or one at another site has met the track since.
void NextMeeting::aimAt(Track& track, const tws::SectorRef& sector) const {
  const RadarState& radar = radars_.at(sector.radar);
  const tws::Antenna& antenna = radar.antenna;
  const bool from_here = radars_.at(track.predicted.radar).site == radar.site;
  const double azimuth =
      from_here ? track.predicted.azimuth
                : motion_.apparentPosition(track, sector.radar, antenna.timeAt(tws::Antenna::startOf(sector.running)))
                      .azimuth;
  const double time = antenna.timeAt(tws::Antenna::near(azimuth, sector.running));
  if (track.predicted.radar == sector.radar && std::abs(time - track.predicted.time) < kPredictionTolerance) return;
  motion_.predict(track, sector.radar, time, radar.quality);
}

void NextMeeting::moveOn(TrackFile::Slot slot, std::size_t radar) {
  const std::size_t site = radars_.at(radar).site;
  const int from = tracks_.sector(slot, site);
  int to = tws::sectorOf(tracks_.at(slot).predicted.azimuth);
  for (std::size_t other = 0; other < radars_.size(); ++other) {
    if (other != radar && radars_.at(other).site == site && from != to && wouldMiss(from, to, other)) to = from;
  }
  tracks_.place(slot, to, site);
  for (std::size_t other = 0; other < radars_.sites().size(); ++other) {
    if (other != site) renewElsewhere(slot, other);
  }
}

void NextMeeting::refile(TrackFile::Slot slot) {
  Track& track = tracks_.at(slot);
  predict(track, 0);
  const int from = tracks_.sector(slot), to = tws::sectorOf(track.predicted.azimuth);
  if (from == to) return;
  for (std::size_t radar = 0; radar < radars_.size(); ++radar)
    if (wouldMiss(from, to, radar)) return;
  tracks_.place(slot, to);
}

/// The sector in which the track's next illumination by a radar of another site will be, as far as is known now.
int NextMeeting::sectorElsewhere(const Track& track, std::size_t site) const {
  double earliest = std::numeric_limits<double>::infinity();
  for (std::size_t radar = 0; radar < radars_.size(); ++radar) {
    if (scans(radar, site)) earliest = std::min(earliest, nextIllumination(track, radar));
  }
  const Kinematics& k = track.smoothed;
  const double dt = std::isfinite(earliest) ? earliest - k.time : 0.0;
  return tws::sectorOf(radars_.sites()[site].view(k.x + k.vx * dt, k.y + k.vy * dt).azimuth);
}

/// What one site has learned of a track is of use to the others.
void NextMeeting::renewElsewhere(TrackFile::Slot slot, std::size_t site) {
  const int from = tracks_.sector(slot, site), to = sectorElsewhere(tracks_.at(slot), site);
  if (from == to) return;
  for (std::size_t radar = 0; radar < radars_.size(); ++radar) {
    if (radars_.at(radar).site == site && wouldMiss(from, to, radar)) return;
  }
  tracks_.place(slot, to, site);
}

void NextMeeting::enter(TrackFile::Slot slot, std::size_t site) {
  Track& track = tracks_.at(slot);
  predict(track, site);
  tracks_.place(slot, tws::sectorOf(track.predicted.azimuth), site);
  for (std::size_t other = 0; other < radars_.sites().size(); ++other) {
    if (other != site) tracks_.place(slot, sectorElsewhere(track, other), other);
  }
}

void NextMeeting::addSite(const Slots& living) {
  tracks_.addSite();
  const std::size_t site = radars_.sites().size() - 1;
  for (const auto slot : living) tracks_.place(slot, sectorElsewhere(tracks_.at(slot), site), site);
}

/// Has the other radar's processing passed the new sector, but not the old one?
bool NextMeeting::wouldMiss(int from, int to, std::size_t radar) const {
  if (!radars_.antenna(radar).known() || order_.silent(radar)) return false;
  const int front = tws::Antenna::sectorNumber(order_.front(radar));
  return tws::sectorDifference(from, front) >= 0 && tws::sectorDifference(to, front) < 0 &&
         std::abs(tws::sectorDifference(to, from)) < tws::kSectors / 4;
}

/// When the beam of a radar meets the track next, in a sector that is still to be processed [s].
double NextMeeting::nextIllumination(const Track& track, std::size_t radar) const {
  const tws::Antenna& antenna = radars_.antenna(radar);
  const double earliest = std::max(tws::Antenna::startOf(order_.front(radar)), track.illuminated[radar] + tws::kPi);
  const auto atLeast = [&](double azimuth) { return earliest + tws::wrapTwoPi(azimuth - earliest); };
  const ApparentPosition seen = motion_.apparentPosition(track, radar, track.smoothed.time);
  const double guess = atLeast(seen.azimuth);
  // Right over the site, azimuth rates have no meaning: half a turn at most.
  const double moved =
      std::clamp(seen.azimuth_rate * (antenna.timeAt(guess) - track.smoothed.time), -tws::kPi, tws::kPi);
  double crossing = guess + moved;
  if (crossing < earliest) crossing += tws::kTwoPi;
  return antenna.timeAt(crossing);
}

void NextMeeting::predict(Track& track, std::size_t site) const {
  std::size_t next = radars_.size();
  double earliest = 0.0;
  for (std::size_t radar = 0; radar < radars_.size(); ++radar) {
    if (!scans(radar, site)) continue;
    const double time = nextIllumination(track, radar);
    if (next < radars_.size() && time >= earliest) continue;
    next = radar;
    earliest = time;
  }
  if (next == radars_.size()) return;  // all radars are silent: the sectors still in hand are the last
  motion_.predict(track, next, earliest, radars_.quality(next));
}

}  // namespace adit_tracker
