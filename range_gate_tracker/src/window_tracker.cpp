#include "window_tracker.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <tws_core/angles.h>
#include <tws_core/geometry.h>
#include <tws_core/sectors.h>

namespace range_gate_tracker {
namespace {

// The beam's time decides the sector of a detection, not its measured azimuth: one sector more on either side.
constexpr std::int64_t kMargin = 1;
// No window is wider than a third of a turn and its margins: older plots are no longer needed.
constexpr std::int64_t kKept = 48;

const WindowParams& checked(const WindowParams& params) {
  check(params);
  return params;
}

bool isGood(const tws::Plot& plot) {
  return plot.range > 0.0 && std::isfinite(plot.range) && std::isfinite(plot.azimuth) && std::isfinite(plot.time);
}

/// The window of a track in which a detection of that sector would be its next, or was its latest.
const TrackWindow* windowOf(const TrackFile& track, std::int64_t running) {
  if (track.window.isOpenIn(running)) return &track.window;
  return track.previous.isOpenIn(running) ? &track.previous : nullptr;
}

}  // namespace

WindowTracker::WindowTracker(const WindowParams& params, OnReport on_report)
    : params_(checked(params)),
      on_report_(std::move(on_report)),
      motion_(params_),
      antenna_(params_.period, tws::kSectors / 2),
      numbers_(static_cast<std::uint32_t>(params_.capacity)) {}

// The five stages of the thesis. (2) The windows are opened by (5), for the next scan.
void WindowTracker::process(const tws::RadarSector& sector) {
  antenna_.cross(sector.running, sector.enter_time);
  now_ = sector.leave_time;
  detect(sector);  // (1) target detection
  for (auto& [number, track] : tracks_) {
    if (track.window.close <= sector.running) decide(track);  // (4) resolution of ambiguity, (5) filtering, prediction
  }
  initiate(sector.running);  // (3) track initiation
  report(sector);
}

void WindowTracker::detect(const tws::RadarSector& sector) {
  plots_.forgetBefore(sector.running - kKept);
  std::vector<tws::Plot> good;
  std::copy_if(sector.plots.begin(), sector.plots.end(), std::back_inserter(good), isGood);
  counts_.rejected_plots += sector.plots.size() - good.size();
  plots_.add(sector.running, good);
}

void WindowTracker::decide(TrackFile& track) {
  std::vector<tws::Plot> seen;
  for (HeldPlot* held : plotsIn(track)) {
    seen.push_back(held->plot);
    held->used = true;
  }
  if (seen.empty())
    miss(track);
  else
    take(track, resolved(seen, track.window, params_.ambiguity));
  openNext(track);
}

std::vector<HeldPlot*> WindowTracker::plotsIn(const TrackFile& track) {
  std::vector<HeldPlot*> inside;
  for (HeldPlot* held : plots_.in(track.window))
    if ((track.window.tracking || !held->used) && !isClaimed(*held, track)) inside.push_back(held);
  return inside;
}

/// Tracking windows come before acquisition windows, and those of isConfirmed tracks before others.
int WindowTracker::rankOf(const TrackFile& track) const { return isConfirmed(track) ? 2 : int{track.window.tracking}; }

bool WindowTracker::isClaimed(const HeldPlot& held, const TrackFile& by) const {
  const int rank = rankOf(by);
  return windows_.any(held.plot, [&](const TrackFile& other) {
    if (other.number == by.number) return false;
    const int its = rankOf(other);
    const bool stronger = its > rank || (its == rank && rank > 0 && params_.overlap == Overlap::kMomentum);
    if (!stronger) return false;
    const TrackWindow* window = windowOf(other, held.running);
    return window != nullptr && window->tracking && window->contains(held.plot);
  });
}

void WindowTracker::take(TrackFile& track, const tws::Plot& plot) {
  if (!track.motion) {
    track.motion = motion_.start(plot);
    track.first_time = plot.time;
  } else {
    const double dt = plot.time - track.motion->time;
    if (track.hits >= 2) learnError(track.error, plot, at(track, plot.time), params_.error_weight);
    if (track.hits == 1) track.error = firstError(plot.range, dt, sigmasOf(plot, params_), params_);
    motion_.update(*track.motion, plot);
  }
  track.measured = plot;
  track.last_update = plot.time;
  ++track.hits;
  track.misses = 0;
  track.type = typeOf(track.type, track.baseline, plot, params_);
  track.priority = priorityOf(track.type, at(track, plot.time), params_);
  news_.emplace_back(track.number, WindowEvent::kUpdated);
}

void WindowTracker::miss(TrackFile& track) {
  ++track.misses;
  news_.emplace_back(track.number, WindowEvent::kMissed);
}

/// Where and when the beam will meet the target next, and the window there.
void WindowTracker::openNext(TrackFile& track) {
  const double period = antenna_.period();
  const double latest = track.misses == 0 ? track.last_update : track.window.time;
  double time = latest + period;
  WindowKinematics predicted;
  for (int i = 0; i < 3; ++i) {
    predicted = at(track, time);
    time += tws::angularDifference(predicted.azimuth, antenna_.azimuthAt(time)) / tws::kTwoPi * period;
  }
  predicted = at(track, std::max(time, latest + 0.5 * period));
  const PlotSigmas sigmas = sigmasOf(track.measured, params_);
  const double dt = predicted.time - track.last_update;
  windows_.remove(track, track.previous);
  track.previous = track.window;
  track.window.tracking = track.hits >= 2;
  openWindow(track, predicted,
             track.window.tracking ? trackingSize(predicted.range, dt, sigmas, track.error, track.misses, params_)
                                   : acquisitionSize(predicted.range, dt, sigmas, params_));
}

void WindowTracker::openWindow(TrackFile& track, const WindowKinematics& predicted, const WindowSize& size) {
  const std::int64_t middle = antenna_.runningAt(predicted.time);
  const auto half = static_cast<std::int64_t>(std::ceil(size.azimuth / tws::kSectorWidth)) + kMargin;
  TrackWindow& window = track.window;
  window.time = predicted.time;
  window.range = predicted.range;
  window.azimuth = predicted.azimuth;
  window.half_range = size.range;
  window.half_azimuth = size.azimuth;
  window.open = std::max(middle - half, track.previous.close + 1);
  window.close = std::max(middle + half, window.open);
  windows_.add(track, window);
}

/// A detection starts a track as soon as no window that holds it is still to be decided; one in a tracking window
/// belongs to that track, taken or not.
void WindowTracker::initiate(std::int64_t running) {
  for (HeldPlots::Sector& sector : plots_.sectors()) {
    if (sector.running > running - 2 * kMargin) break;
    const bool crowded = sector.plots.size() > kMostPlots;
    for (HeldPlot& held : sector.plots) {
      if (held.used || isAwaited(held, running)) continue;
      held.used = true;
      if (!params_.automatic || belongsToATrack(held)) continue;
      if (crowded)
        ++counts_.crowded_plots;
      else
        startAt(held);
    }
  }
}

void WindowTracker::startAt(const HeldPlot& held) {
  TrackFile* track = open(held.plot.time);
  if (track == nullptr) return;
  take(*track, held.plot);
  news_.back().second = WindowEvent::kStarted;
  openNext(*track);
}

bool WindowTracker::isAwaited(const HeldPlot& held, std::int64_t running) const {
  return windows_.any(held.plot, [&](const TrackFile& track) {
    const TrackWindow& window = track.window;
    return window.close > running && window.isOpenIn(held.running) && window.contains(held.plot);
  });
}

bool WindowTracker::belongsToATrack(const HeldPlot& held) const {
  return windows_.any(held.plot, [&](const TrackFile& track) {
    const TrackWindow* window = windowOf(track, held.running);
    return window != nullptr && window->tracking && window->contains(held.plot);
  });
}

/// A new track file; null when all numbers are in use.
TrackFile* WindowTracker::open(double time) {
  const std::optional<std::uint32_t> number = numbers_.take();
  if (!number) {
    ++counts_.refused_tracks;
    return nullptr;
  }
  TrackFile& track = tracks_[*number];
  track.number = *number;
  track.uid = next_uid_++;
  track.first_time = track.last_update = time;
  return &track;
}

std::optional<std::uint32_t> WindowTracker::designate(double range, double azimuth) {
  if (!antenna_.known()) return std::nullopt;
  TrackFile* track = open(now_);
  if (track == nullptr) return std::nullopt;
  track->designated = true;
  track->measured.time = now_;
  track->measured.range = range;
  track->measured.azimuth = tws::wrapTwoPi(azimuth);
  // The marker was set on a picture that is up to a scan old.
  const double ahead = tws::wrapTwoPi(azimuth - antenna_.azimuthAt(now_)) / tws::kTwoPi * antenna_.period();
  openWindow(*track, at(*track, now_ + ahead),
             acquisitionSize(range, ahead + antenna_.period(), sigmasOf(track->measured, params_), params_));
  news_.emplace_back(track->number, WindowEvent::kStarted);
  return track->number;
}

bool WindowTracker::cancel(std::uint32_t number) {
  const auto found = tracks_.find(number);
  if (found == tracks_.end()) return false;
  // The number may be another track's before the next report.
  news_.erase(std::remove_if(news_.begin(), news_.end(), [&](const auto& n) { return n.first == number; }),
              news_.end());
  close(found);
  return true;
}

void WindowTracker::close(std::map<std::uint32_t, TrackFile>::iterator track) {
  numbers_.drop(track->first);
  windows_.remove(track->second, track->second.window);
  windows_.remove(track->second, track->second.previous);
  dropped_.push_back(std::move(track->second));
  tracks_.erase(track);
}

void WindowTracker::cancelAll() {
  news_.clear();
  while (!tracks_.empty()) close(tracks_.begin());
}

bool WindowTracker::isConfirmed(const TrackFile& track) const {
  return track.hits >= params_.firm_hits && (track.designated || track.type >= TargetType::kSurface);
}

WindowKinematics WindowTracker::at(const TrackFile& track, double time) const {
  if (track.motion) return motion_.at(*track.motion, time);
  WindowKinematics marker;
  marker.time = time;
  marker.range = track.measured.range;
  marker.azimuth = track.measured.azimuth;
  marker.position = tws::planarFromPolar(marker.range, marker.azimuth);
  return marker;
}

/// What is reported of them is that.
void WindowTracker::cancelLost() {
  for (auto track = tracks_.begin(); track != tracks_.end();) {
    const auto next = std::next(track);
    const int most = isConfirmed(track->second) ? params_.missed_scans : params_.acquisition_scans;
    if (track->second.misses >= most) close(track);
    track = next;
  }
}

void WindowTracker::report(const tws::RadarSector& sector) {
  cancelLost();
  WindowReport report{sector.running, sector.enter_time, {}};
  for (const TrackFile& track : dropped_) report.updates.push_back({&track, WindowEvent::kDropped});
  for (const auto& [number, event] : news_) {
    const auto found = tracks_.find(number);
    if (found != tracks_.end()) report.updates.push_back({&found->second, event});
  }
  on_report_(report);
  dropped_.clear();
  news_.clear();
}

}  // namespace range_gate_tracker
