// How Adit finds where a beam meets a track next, and keeps tracks in the sectors of each site.
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

#include "core/adit.h"

namespace adit_tracker {
namespace {

// A prediction that is off by less in time is not made anew.
constexpr double kPredictionTolerance = 0.3;  // [s]

}  // namespace

Seen Adit::seenBy(TrackFile::Slot slot, std::size_t radar, double time) const {
  if (motion_.joined()) return motion_.seenBy(tracks_.at(slot), radar, time);
  const Kinematics k = at(slot, time).kinematics;
  return {k.range, k.azimuth, k.azimuth_rate};
}

/// Updated or missed: a track that has moved on into the next sector has had its chance all the same.
bool Adit::metOnThisScan(const Track& track, std::size_t radar, std::int64_t running) {
  return track.illuminated[radar] > tws::Antenna::startOf(running) - tws::kPi;
}

/// Sees to it that the prediction is for this radar's beam in that sector. It mostly is already; not so when another
/// radar, which should have come first, is silent, or one at another site has met the track since.
void Adit::aimAt(Track& track, std::size_t radar, std::int64_t running) {
  const tws::Antenna& antenna = radars_[radar].antenna;
  const bool from_here = radars_[track.predicted.radar].site == radars_[radar].site;
  const double azimuth = from_here
                             ? track.predicted.azimuth
                             : motion_.seenBy(track, radar, antenna.timeAt(tws::Antenna::startOf(running))).azimuth;
  const double time = antenna.timeAt(tws::Antenna::near(azimuth, running));
  if (track.predicted.radar == radar && std::abs(time - track.predicted.time) < kPredictionTolerance) return;
  motion_.predict(track, radar, time, radars_[radar].quality);
}

/// Puts the track into the sector where its next illumination will be.
void Adit::moveOn(TrackFile::Slot slot, std::size_t radar) {
  if (!dropped_.empty() && std::find(dropped_.begin(), dropped_.end(), slot) != dropped_.end()) return;
  const std::size_t site = radars_[radar].site;
  const int from = tracks_.sector(slot, site);
  int to = tws::sectorOf(tracks_.at(slot).predicted.azimuth);
  for (std::size_t other = 0; other < radars_.size(); ++other) {
    if (other != radar && radars_[other].site == site && from != to && wouldMissUpdate(from, to, other)) to = from;
  }
  tracks_.place(slot, to, site);
  for (std::size_t other = 0; other < sites_.size(); ++other) {
    if (other != site) renewElsewhere(slot, other);
  }
}

/// The sector in which the track's next illumination by a radar of another site will be, as far as is known now.
int Adit::sectorElsewhere(const Track& track, std::size_t site) const {
  const tws::SiteFrame& frame = sites_[site];
  double earliest = std::numeric_limits<double>::infinity();
  for (std::size_t radar = 0; radar < radars_.size(); ++radar) {
    if (radars_[radar].site != site || !radars_[radar].antenna.known() || order_.silent(radar)) continue;
    earliest = std::min(earliest, nextIllumination(track, radar));
  }
  const Kinematics& k = track.smoothed;
  const double dt = std::isfinite(earliest) ? earliest - k.time : 0.0;
  return tws::sectorOf(frame.view(k.x + k.vx * dt, k.y + k.vy * dt).azimuth);
}

/// What one site has learned of a track is of use to the others.
void Adit::renewElsewhere(TrackFile::Slot slot, std::size_t site) {
  const int from = tracks_.sector(slot, site), to = sectorElsewhere(tracks_.at(slot), site);
  if (from == to) return;
  for (std::size_t radar = 0; radar < radars_.size(); ++radar) {
    if (radars_[radar].site == site && wouldMissUpdate(from, to, radar)) return;
  }
  tracks_.place(slot, to, site);
}

/// Puts a new track into the sectors of all sites; `site`: whose radar has seen it.
void Adit::enterSectors(TrackFile::Slot slot, std::size_t site) {
  Track& track = tracks_.at(slot);
  predictNext(track, site);
  tracks_.place(slot, tws::sectorOf(track.predicted.azimuth), site);
  for (std::size_t other = 0; other < sites_.size(); ++other) {
    if (other != site) tracks_.place(slot, sectorElsewhere(track, other), other);
  }
}

void Adit::place(std::size_t radar, const tws::SiteFrame& frame) {
  RadarState& state = radars_.at(radar);
  if (order_.newest(radar) >= 0 || tws::sameSite(frame, sites_.front())) return;
  if (!joinsSites(params_)) {
    throw std::invalid_argument("radar " + params_.radars[radar].name +
                                ": radars at different sites need the turning filter and a clutter map for each radar");
  }
  state.frame = frame;
  state.joined = false;
}

/// The first sector of a radar at another site is about to be processed.
void Adit::joinSite(std::size_t radar) {
  RadarState& state = radars_[radar];
  state.joined = true;
  const auto known = std::find_if(sites_.begin(), sites_.end(),
                                  [&](const tws::SiteFrame& site) { return tws::sameSite(site, state.frame); });
  const bool is_new = known == sites_.end(), is_second = sites_.size() == 1;
  state.site = static_cast<std::size_t>(known - sites_.begin());
  if (is_new) sites_.push_back(state.frame);
  std::vector<tws::SiteFrame> frames;
  for (const RadarState& each : radars_) frames.push_back(each.joined ? each.frame : tws::SiteFrame{});
  motion_.join(frames);
  if (!is_new) return;
  tracks_.addSite();
  for (const auto slot : living()) {
    if (is_second) motion_.guessHeight(tracks_.at(slot));
    tracks_.place(slot, sectorElsewhere(tracks_.at(slot), state.site), state.site);
  }
}

/// Whether a radar of another site sees the target at all, nobody knows yet.
void Adit::doubtOtherSites(Track& track, std::size_t radar) const {
  constexpr float kPerhaps = 0.3F;
  for (std::size_t other = 0; other < radars_.size(); ++other) {
    if (radars_[other].site != radars_[radar].site) track.detection_probability[other] = kPerhaps;
  }
}

/// Is the target of one site beyond the reach of the other's radar? Then it is not missed there.
bool Adit::outOfReach(const Track& track, const RadarQuality& quality) const {
  constexpr double kRecently = 30.0;  // [s]
  return sites_.size() > 1 && track.predicted.range > quality.greatestRange() &&
         track.predicted.time - track.last_update < kRecently;
}

/// Has the other radar's processing passed the new sector, but not the old one? Then the track stays where it is.
bool Adit::wouldMissUpdate(int from, int to, std::size_t radar) const {
  if (!radars_[radar].antenna.known() || order_.silent(radar)) return false;
  const int front = tws::Antenna::sectorNumber(order_.front(radar));
  return tws::sectorDifference(from, front) >= 0 && tws::sectorDifference(to, front) < 0 &&
         std::abs(tws::sectorDifference(to, from)) < tws::kSectors / 4;
}

/// When the beam of a radar meets the track next, in a sector that is still to be processed [s].
double Adit::nextIllumination(const Track& track, std::size_t radar) const {
  const tws::Antenna& antenna = radars_[radar].antenna;
  const double earliest = std::max(tws::Antenna::startOf(order_.front(radar)), track.illuminated[radar] + tws::kPi);
  const auto atLeast = [&](double azimuth) { return earliest + tws::wrapTwoPi(azimuth - earliest); };
  const Seen seen = motion_.seenBy(track, radar, track.smoothed.time);
  const double guess = atLeast(seen.azimuth);
  // Right over the site, azimuth rates have no meaning: half a turn at most.
  const double moved =
      std::clamp(seen.azimuth_rate * (antenna.timeAt(guess) - track.smoothed.time), -tws::kPi, tws::kPi);
  double crossing = guess + moved;
  if (crossing < earliest) crossing += tws::kTwoPi;
  return antenna.timeAt(crossing);
}

/// T2 of the report: the earliest next time that any radar of that site will illuminate the track.
void Adit::predictNext(Track& track, std::size_t site) {
  std::size_t next = radars_.size();
  double earliest = 0.0;
  for (std::size_t radar = 0; radar < radars_.size(); ++radar) {
    if (radars_[radar].site != site || !radars_[radar].antenna.known() || order_.silent(radar)) continue;
    const double time = nextIllumination(track, radar);
    if (next < radars_.size() && time >= earliest) continue;
    next = radar;
    earliest = time;
  }
  if (next == radars_.size()) return;  // all radars are silent: the sectors still in hand are the last
  motion_.predict(track, next, earliest, radars_[next].quality);
}

}  // namespace adit_tracker
