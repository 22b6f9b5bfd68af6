#include "iff/iff_watch.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace adit_tracker {
namespace {

constexpr double kGateSigmas = 4.0;
// Further away [m] no track is looked at: it is faster than a search by its covariance.
constexpr double kFarAway = 5e3;
// A plot is looked at when the tracks are half a second past it, some seconds at most [s]. Further back a filter's
// covariance says nothing: it is made to go forward.
constexpr double kFurthestBack = 5.0;
constexpr double kTurnsWithoutAnswer =
    1.5;  // … and the secondary radar is not detecting it, whatever became of its beam

tws::Plot corrected(tws::Plot plot, const IffParams& params) {
  plot.range = std::max(plot.range - params.range_bias, 1.0);
  plot.azimuth = tws::wrapTwoPi(plot.azimuth - params.azimuth_bias);
  return plot;
}

/// The tracks in the sectors around a place on the plane.
void listAround(const TrackFile& tracks, double x, double y, std::vector<TrackFile::Slot>& slots) {
  constexpr double kAside = 5e3;  // how far from its sector's middle line a track may be [m]
  const int middle = tws::sectorOf(tws::wrapTwoPi(std::atan2(x, y)));
  const double width = kAside / std::max(std::hypot(x, y), 1.0) / tws::kSectorWidth;
  const int reach = static_cast<int>(std::min(2.0 + width, 0.5 * tws::kSectors - 1.0));
  slots.clear();
  for (int s = middle - reach; s <= middle + reach; ++s) tracks.list(tws::wrapSector(s), slots);
}

}  // namespace

IffWatch::IffWatch(const std::vector<IffParams>& params) {
  for (const IffParams& each : params) interrogators_.emplace_back().params = each;
}

bool IffWatch::add(std::size_t iff, tws::RadarSector sector, const tws::SiteFrame& site) {
  if (sector.leave_time + kDelay <= applied_) return false;
  auto& waiting = interrogators_.at(iff).waiting;
  const auto later = [](double time, const Sector& other) { return time < other.heard.leave_time; };
  const auto place = std::upper_bound(waiting.begin(), waiting.end(), sector.leave_time, later);
  waiting.insert(place, {std::move(sector), site});
  return true;
}

void IffWatch::apply(double time, TrackFile& tracks, const TrackMotion& motion) {
  applied_ = std::max(applied_, time);
  for (std::size_t i = 0; i < interrogators_.size(); ++i) {
    Interrogator& iff = interrogators_[i];
    for (; !iff.waiting.empty() && iff.waiting.front().heard.leave_time + kDelay <= applied_; iff.waiting.pop_front())
      look(i, iff.waiting.front(), tracks, motion);
    const double oldest = applied_ - kDelay - kTurnsWithoutAnswer * iff.period;
    clear(i, tracks, [&](const Answer& answer) { return answer.time < oldest; });
  }
}

void IffWatch::look(std::size_t iff, const Sector& sector, TrackFile& tracks, const TrackMotion& motion) {
  Interrogator& interrogator = interrogators_[iff];
  const double duration = sector.heard.leave_time - interrogator.latest;
  constexpr double kShortest = 0.005, kLongest = 2.0;  // of a sector [s]
  if (duration > kShortest && duration < kLongest) interrogator.period = duration * tws::kSectors;
  interrogator.latest = sector.heard.leave_time;
  collect(interrogator, sector, tracks, motion);
  std::vector<bool> taken(sector.heard.plots.size());
  for (const Pair& pair : pairs_) {
    const std::uint32_t uid = tracks.at(pair.slot).uid;
    const bool answered = std::any_of(interrogator.answers.begin(), interrogator.answers.end(), [&](const Answer& a) {
      return a.slot == pair.slot && a.uid == uid && sector.heard.leave_time - a.time < 0.5 * interrogator.period;
    });
    if (taken[pair.plot] || answered) continue;
    taken[pair.plot] = true;
    answer(iff, pair.slot, sector.heard.plots[pair.plot].time, tracks);
  }
  clearMissed(iff, sector, tracks);
}

/// Every track with every plot that may be its own; the nearest first.
void IffWatch::collect(const Interrogator& iff, const Sector& sector, const TrackFile& tracks,
                       const TrackMotion& motion) {
  pairs_.clear();
  for (std::size_t i = 0; i < sector.heard.plots.size(); ++i) {
    const tws::Plot plot = corrected(sector.heard.plots[i], iff.params);
    const double azimuth = sector.site.onPlane(plot.azimuth);
    const double x = sector.site.x + plot.range * std::sin(azimuth), y = sector.site.y + plot.range * std::cos(azimuth);
    listAround(tracks, x, y, near_);
    for (const auto slot : near_) {
      const Kinematics& k = tracks.at(slot).smoothed;
      const double dt = plot.time - k.time;
      if (dt < -kFurthestBack) continue;
      if (std::hypot(k.x + k.vx * dt - x, k.y + k.vy * dt - y) > kFarAway) continue;
      const double distance =
          motion.squaredDistance(tracks.at(slot), plot, iff.params.range_sigma, iff.params.azimuth_sigma, sector.site);
      if (distance >= 0.0 && distance <= kGateSigmas * kGateSigmas) pairs_.push_back({distance, slot, i});
    }
  }
  const auto key = [&](const Pair& p) { return std::make_tuple(p.distance, tracks.at(p.slot).uid, p.plot); };
  std::sort(pairs_.begin(), pairs_.end(), [&](const Pair& a, const Pair& b) { return key(a) < key(b); });
}

void IffWatch::answer(std::size_t iff, TrackFile::Slot slot, double time, TrackFile& tracks) {
  Track& track = tracks.at(slot);
  track.answers_iff = static_cast<std::uint8_t>(track.answers_iff | 1U << iff);
  auto& answers = interrogators_[iff].answers;
  const auto known = std::find_if(answers.begin(), answers.end(), [&](const Answer& a) { return a.slot == slot; });
  (known == answers.end() ? answers.emplace_back() : *known) = {slot, track.uid, time};
}

/// The tracks of the sector before had their chance: their plots may, by the radar's errors, have come in this one.
void IffWatch::clearMissed(std::size_t iff, const Sector& sector, TrackFile& tracks) {
  const Interrogator& interrogator = interrogators_[iff];
  const double time = sector.heard.leave_time - 1.5 * interrogator.period / tws::kSectors;
  const int before = tws::wrapSector(sector.heard.sector - 1);
  clear(iff, tracks, [&](const Answer& answer) {
    if (time - answer.time < 0.5 * interrogator.period) return false;
    const Kinematics& k = tracks.at(answer.slot).smoothed;
    const double dt = time - k.time;
    return tws::sectorOf(sector.site.view(k.x + k.vx * dt, k.y + k.vy * dt).azimuth) == before;
  });
}

template <class Gone>
void IffWatch::clear(std::size_t iff, TrackFile& tracks, const Gone& gone) {
  auto& answers = interrogators_[iff].answers;
  const auto isOver = [&](const Answer& answer) {
    Track& track = tracks.at(answer.slot);
    if (track.uid != answer.uid) return true;  // dropped; its slot has a new track
    if (!gone(answer)) return false;
    track.answers_iff = static_cast<std::uint8_t>(track.answers_iff & ~(1U << iff));
    return true;
  };
  answers.erase(std::remove_if(answers.begin(), answers.end(), isOver), answers.end());
}

}  // namespace adit_tracker
