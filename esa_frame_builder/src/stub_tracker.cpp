#include "stub_tracker.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include <tws_core/angles.h>

namespace esa_frame_builder {
namespace {

// Log-likelihood of an innovation.
double logLikelihood(const tws::SpatialInnovation& innovation) {
  return -0.5 * (innovation.nis + std::log(innovation.covariance.determinant()) + 3.0 * std::log(tws::kTwoPi));
}

// Of several words about a track only the last.
std::vector<TrackWord> lastWords(const std::vector<TrackWord>& words) {
  std::map<std::uint32_t, TrackWord> last;
  for (const TrackWord& word : words) last[word.track.number] = word;
  std::vector<TrackWord> result;
  for (const auto& [number, word] : last) result.push_back(word);
  return result;
}

}  // namespace

void StubTracker::take(const FrameWindow& window) {
  const Frame& frame = window.closed().front();
  const std::vector<Plot> plots = plotsOf(frame);
  const std::vector<bool> used = update(tracks_, frame, plots, words_);
  judge(frame);
  initiate(plots, used);
}

TrackReport StubTracker::report(const FrameWindow& window) {
  TrackReport report;
  std::vector<Kept> tracks = tracks_;
  for (const Frame& frame : window.open()) update(tracks, frame, plotsOf(frame), words_);
  report.words = lastWords(words_);
  words_.clear();
  for (const Kept& kept : tracks) report.living.push_back(kept.track);
  return report;
}

std::vector<StubTracker::Plot> StubTracker::plotsOf(const Frame& frame) const {
  std::vector<Plot> plots;
  for (const Dwell& dwell : frame.dwells)
    for (const Measurement& measurement : dwell.measurements) {
      const tws::SpatialMeasurement place = spatialMeasurement(measurement, pose_);
      // At the very edge of the visible region a direction says nothing about the distance along boresight.
      if (place.position.allFinite() && place.covariance.allFinite())
        plots.push_back({dwell.time, measurement.snr, place});
    }
  return plots;
}

std::vector<bool> StubTracker::update(std::vector<Kept>& tracks, const Frame& frame, const std::vector<Plot>& plots,
                                      std::vector<TrackWord>& words) {
  std::vector<FrameView> views;
  for (const Kept& kept : tracks) views.push_back(viewOf(kept.track, frame, pose_, params_));
  const std::vector<int> plot_of = associate(tracks, views, plots);
  std::vector<bool> used(plots.size(), false);
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    TrackWord word;
    if (plot_of[i] >= 0) {
      const std::size_t plot = static_cast<std::size_t>(plot_of[i]);
      used[plot] = true;
      see(tracks[i], plots[plot], views[i].detection_probability);
      word.track = tracks[i].track;
    } else if (views[i].detection_probability >= params_.least_detection_probability) {
      miss(tracks[i], views[i], word);
    } else {
      continue;  // Out of view: neither said nor scored.
    }
    words.push_back(word);
  }
  return used;
}

std::vector<int> StubTracker::associate(const std::vector<Kept>& tracks, const std::vector<FrameView>& views,
                                        const std::vector<Plot>& plots) {
  pairs_.clear();
  for (std::size_t row = 0; row < tracks.size(); ++row) addPairs(row, tracks[row], views[row], plots);
  return solver_.solve(pairs_, tracks.size(), plots.size(), 0.0);
}

// A pair costs what it makes the track less likely, compared with a miss.
void StubTracker::addPairs(std::size_t row, const Kept& kept, const FrameView& view, const std::vector<Plot>& plots) {
  const double chance = std::clamp(view.detection_probability, params_.least_detection_probability, 0.999);
  tws::SpatialState state;
  double time = -1.0;
  for (std::size_t column = 0; column < plots.size(); ++column) {
    const Plot& plot = plots[column];
    if (plot.time < kept.track.time) continue;
    if (plot.time != time) {
      state = kept.track.state;
      tws::predict(state, plot.time - kept.track.time, params_.acceleration_density);
      time = plot.time;
    }
    const tws::SpatialInnovation innovation = tws::innovation(state, plot.place);
    if (!(innovation.nis <= params_.gate_chi2)) continue;
    const double gain = logLikelihood(innovation) + std::log(chance / ((1.0 - chance) * params_.extraneous_density));
    if (gain > 0.0) pairs_.push_back({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column), -gain});
  }
}

void StubTracker::see(Kept& kept, const Plot& plot, double chance) const {
  FrameTrack& track = kept.track;
  tws::predict(track.state, plot.time - track.time, params_.acceleration_density);
  const tws::SpatialInnovation innovation = tws::innovation(track.state, plot.place);
  tws::update(track.state, plot.place, innovation);
  track.time = track.last_update = plot.time;
  track.score += logLikelihood(innovation) +
                 std::log(std::max(chance, params_.least_detection_probability) / params_.extraneous_density);
  kept.best_score = std::max(kept.best_score, track.score);
  ++kept.hits;
  track.snr += (plot.snr - track.snr) / std::min(kept.hits, 10);
}

// The word shows the track where it should have been seen; the track itself stays at its last update.
void StubTracker::miss(Kept& kept, const FrameView& view, TrackWord& word) const {
  kept.track.score += std::log(1.0 - std::min(view.detection_probability, 0.999));
  word.track = kept.track;
  word.seen = FrameCase::kMissed;
  tws::predict(word.track.state, view.time - kept.track.time, params_.acceleration_density);
  word.track.time = view.time;
}

void StubTracker::judge(const Frame& frame) {
  const double now = frame.dwells.empty() ? 0.0 : frame.dwells.back().time;
  for (Kept& kept : tracks_) {
    ++kept.frames;
    if (kept.hits >= params_.initiation_hits) kept.track.stage = TrackStage::kFirm;
    if (!isLost(kept, now)) continue;
    words_.push_back({kept.track, FrameCase::kMissed, true});
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
    words_.push_back({kept.track, FrameCase::kSeen, false});
    tracks_.push_back(std::move(kept));
  }
}

}  // namespace esa_frame_builder
