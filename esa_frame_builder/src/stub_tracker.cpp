#include "stub_tracker.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include <tws_core/angles.h>

namespace esa_frame_builder {
namespace {

constexpr double kSurest = 0.999;  // detection probability

// Log-likelihood of an innovation.
double logLikelihood(const tws::SpatialInnovation& innovation) {
  return -0.5 * (innovation.nis + std::log(innovation.covariance.determinant()) + 3.0 * std::log(tws::kTwoPi));
}

// Of several updates about a track only the last.
std::vector<TrackUpdate> finalUpdates(const std::vector<TrackUpdate>& updates) {
  std::map<std::uint32_t, TrackUpdate> last;
  for (const TrackUpdate& update : updates) last[update.track.number] = update;
  std::vector<TrackUpdate> result;
  result.reserve(last.size());
  for (const auto& [number, update] : last) result.push_back(update);
  return result;
}

}  // namespace

void StubTracker::take(const FrameWindow& window) {
  const Frame& frame = window.closed().front();
  const Scene scene = sceneOf(tracks_, frame);
  const std::vector<bool> used = update(tracks_, scene, updates_);
  judge(frame);
  initiate(scene.plots, used);
}

TrackReport StubTracker::report(const FrameWindow& window) {
  TrackReport report;
  std::vector<Kept> tracks = tracks_;
  for (const Frame& frame : window.open()) update(tracks, sceneOf(tracks, frame), updates_);
  report.updates = finalUpdates(updates_);
  updates_.clear();
  for (const Kept& kept : tracks) report.living.push_back(kept.track);
  return report;
}

StubTracker::Scene StubTracker::sceneOf(const std::vector<Kept>& tracks, const Frame& frame) const {
  Scene scene;
  for (const Kept& kept : tracks) {
    scene.tracks.push_back(&kept.track);
    scene.views.push_back(viewOf(kept.track, frame, pose_, params_));
  }
  scene.plots = plotsOf(frame);
  return scene;
}

std::vector<StubTracker::Plot> StubTracker::plotsOf(const Frame& frame) const {
  std::vector<Plot> plots;
  for (std::size_t k = 0; k < frame.dwells.size(); ++k)
    for (const Measurement& measurement : frame.dwells[k].measurements) {
      const tws::SpatialMeasurement place = spatialMeasurement(measurement, pose_);
      // At the very edge of the visible region a direction says nothing about the distance along boresight.
      if (place.position.allFinite() && place.covariance.allFinite())
        plots.push_back({k, frame.dwells[k].time, measurement.snr, place});
    }
  return plots;
}

// The likelier of the two.
StubTracker::Reading StubTracker::readingOf(const Scene& scene, std::size_t track, const Plot& plot) const {
  const tws::SpatialState& state = scene.views[track].dwells[plot.dwell].state;
  Reading own{plot.place, tws::innovation(state, plot.place), {}};
  MergedPlot merged = mergedPlot(track, plot.dwell, scene.tracks, scene.views, params_.range_resolution);
  if (merged.members.empty()) return own;
  const tws::SpatialMeasurement part = memberMeasurement(merged, plot.place, state);
  // The place of the merged plot is predicted with the covariance that is already in `part`.
  tws::SpatialState centre;
  centre.mean.head<3>() = state.mean.head<3>();
  Reading shared{part, tws::innovation(centre, part), std::move(merged)};
  return logLikelihood(shared.innovation) > logLikelihood(own.innovation) ? shared : own;
}

std::vector<bool> StubTracker::update(std::vector<Kept>& tracks, const Scene& scene,
                                      std::vector<TrackUpdate>& updates) {
  const std::vector<Taken> taken = take(scene, associate(scene));
  std::vector<bool> used(scene.plots.size(), false);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    TrackUpdate update;
    if (taken[i].plot) {
      used[*taken[i].plot] = true;
      see(tracks[i], scene.views[i], scene.plots[*taken[i].plot], taken[i]);
      update.track = tracks[i].track;
    } else if (scene.views[i].detection_probability >= params_.least_detection_probability) {
      miss(tracks[i], scene.views[i], update);
    } else {
      continue;  // Out of view: neither said nor scored.
    }
    updates.push_back(update);
  }
  return used;
}

std::vector<int> StubTracker::associate(const Scene& scene) {
  pairs_.clear();
  for (std::size_t row = 0; row < scene.tracks.size(); ++row) addPairs(scene, row);
  return solver_.solve(pairs_, scene.tracks.size(), scene.plots.size(), 0.0);
}

// A pair costs what it makes the track less likely, compared with a miss.
void StubTracker::addPairs(const Scene& scene, std::size_t row) {
  const double chance =
      std::clamp(scene.views[row].detection_probability, params_.least_detection_probability, kSurest);
  for (std::size_t column = 0; column < scene.plots.size(); ++column) {
    if (scene.plots[column].time < scene.tracks[row]->time) continue;
    const Reading reading = readingOf(scene, row, scene.plots[column]);
    if (!(reading.innovation.nis <= params_.gate_chi2)) continue;
    const double gain =
        logLikelihood(reading.innovation) + std::log(chance / ((1.0 - chance) * params_.extraneous_density));
    if (gain > 0.0) pairs_.push_back({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column), -gain});
  }
}

std::vector<StubTracker::Taken> StubTracker::take(const Scene& scene, const std::vector<int>& plot_of) const {
  std::vector<Taken> taken(scene.tracks.size());
  for (std::size_t i = 0; i < taken.size(); ++i) {
    if (plot_of[i] < 0) continue;
    const std::size_t plot = static_cast<std::size_t>(plot_of[i]);
    taken[i] = {plot, true, readingOf(scene, i, scene.plots[plot])};
  }
  for (std::size_t i = 0; i < taken.size(); ++i)
    if (taken[i].is_own) share(scene, i, taken);
  return taken;
}

// The other members of a merged plot that have no plot of their own take part in it, unless they cannot be told from
// the giver: then they are one target's tracks, and one of them has to go.
void StubTracker::share(const Scene& scene, std::size_t giver, std::vector<Taken>& taken) const {
  const Plot& plot = scene.plots[*taken[giver].plot];
  const MergedPlot& merged = taken[giver].reading.merged;
  const tws::SpatialState& from = scene.views[giver].dwells[plot.dwell].state;
  for (const std::size_t i : merged.members) {
    if (taken[i].plot) continue;
    const tws::SpatialState& state = scene.views[i].dwells[plot.dwell].state;
    const tws::SpatialMeasurement other{from.mean.head<3>(), from.covariance.topLeftCorner<3, 3>()};
    if (tws::innovation(state, other).nis <= params_.duplicate_chi2) continue;
    taken[i].plot = taken[giver].plot;
    taken[i].reading.measurement = memberMeasurement(merged, plot.place, state);
  }
}

// A share in another track's plot moves the track, but says nothing for or against it.
void StubTracker::see(Kept& kept, const FrameView& view, const Plot& plot, const Taken& taken) const {
  FrameTrack& track = kept.track;
  track.state = view.dwells[plot.dwell].state;
  tws::update(track.state, taken.reading.measurement, tws::innovation(track.state, taken.reading.measurement));
  track.time = track.last_update = plot.time;
  if (!taken.is_own) return;
  track.score +=
      logLikelihood(taken.reading.innovation) +
      std::log(std::max(view.detection_probability, params_.least_detection_probability) / params_.extraneous_density);
  kept.best_score = std::max(kept.best_score, track.score);
  ++kept.hits;
  if (taken.reading.merged.members.empty()) track.snr += (plot.snr - track.snr) / std::min(kept.hits, 10);
}

// The update shows the track where it should have been seen; the track itself stays at its last update.
void StubTracker::miss(Kept& kept, const FrameView& view, TrackUpdate& update) const {
  kept.track.score += std::log(1.0 - std::min(view.detection_probability, kSurest));
  update.track = kept.track;
  update.seen = FrameCase::kMissed;
  tws::predict(update.track.state, view.time - kept.track.time, params_.acceleration_density);
  update.track.time = view.time;
}

void StubTracker::judge(const Frame& frame) {
  const double now = frame.dwells.empty() ? 0.0 : frame.dwells.back().time;
  for (Kept& kept : tracks_) {
    ++kept.frames;
    if (kept.hits >= params_.initiation_hits) kept.track.stage = TrackStage::kFirm;
    if (!isLost(kept, now)) continue;
    updates_.push_back({kept.track, FrameCase::kMissed, true});
    kept.frames = -1;
  }
  tracks_.erase(std::remove_if(tracks_.begin(), tracks_.end(), [](const Kept& kept) { return kept.frames < 0; }),
                tracks_.end());
}

bool StubTracker::isLost(const Kept& kept, double time) const {
  if (kept.track.stage == TrackStage::kTentative && kept.frames >= params_.initiation_frames) return true;
  return kept.track.score < kept.best_score - params_.drop_score ||
         time - kept.track.last_update > params_.greatest_coast;
}

void StubTracker::initiate(const std::vector<Plot>& plots, const std::vector<bool>& used) {
  for (std::size_t i = 0; i < plots.size(); ++i) {
    if (used[i]) continue;
    Kept kept;
    kept.track.number = ++last_number_;
    kept.track.time = kept.track.first_detection = kept.track.last_update = plots[i].time;
    kept.track.state = tws::startState(plots[i].place, params_.speed_sigma);
    kept.track.snr = plots[i].snr;
    updates_.push_back({kept.track, FrameCase::kSeen, false});
    tracks_.push_back(std::move(kept));
  }
}

}  // namespace esa_frame_builder
