#include "nearest_tracker.h"

#include <algorithm>

namespace nearest_tracker {
namespace {

constexpr double kAcceleration = 1.0;   // spectral density [m²/s³]
constexpr double kSpeedSigma = 200.0;   // of a new track, in each axis [m/s]
constexpr double kLeastInterval = 0.5;  // between two plots of a track [s]

NearestTrack predicted(NearestTrack track, double time) {
  tws::predict(track.state, time - track.time, kAcceleration);
  track.time = time;
  return track;
}

}  // namespace

std::vector<NearestTrack> NearestTracker::process(const std::vector<PlanarPlot>& plots, double leave_time) {
  std::vector<NearestTrack> reported;
  for (const PlanarPlot& plot : plots) reported.push_back(update(plot));
  for (NearestTrack& track : tracks_) {
    track.deleted = leave_time - track.last_time > params_.drop;
    if (track.deleted) reported.push_back(predicted(track, leave_time));
  }
  const auto isDeleted = [](const NearestTrack& track) { return track.deleted; };
  tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(), isDeleted), tracks_.end());
  return reported;
}

NearestTrack& NearestTracker::update(const PlanarPlot& plot) {
  NearestTrack* track = nearest(plot);
  if (!track)
    return tracks_.emplace_back(
        NearestTrack{next_number_++, plot.time, plot.time, plot.time, tws::startState(plot.place, kSpeedSigma)});
  *track = predicted(*track, plot.time);
  tws::update(track->state, plot.place, tws::innovation(track->state, plot.place));
  track->last_time = plot.time;
  ++track->plots;
  return *track;
}

NearestTrack* NearestTracker::nearest(const PlanarPlot& plot) {
  NearestTrack* best = nullptr;
  double least = params_.gate_sigmas * params_.gate_sigmas;
  for (NearestTrack& track : tracks_) {
    if (plot.time - track.last_time < kLeastInterval) continue;
    const double distance = tws::innovation(predicted(track, plot.time).state, plot.place).nis;
    if (distance >= least) continue;
    least = distance;
    best = &track;
  }
  return best;
}

}  // namespace nearest_tracker
