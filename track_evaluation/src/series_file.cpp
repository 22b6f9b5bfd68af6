#include "series_file.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace track_evaluation {
namespace {

constexpr double kForever = std::numeric_limits<double>::infinity();

/// Of the pairs with a required truth.
double rmsError(const Epoch& epoch, const std::vector<int>& track_of) {
  std::vector<double> errors;
  for (std::size_t i = 0; i < epoch.truths.size(); ++i) {
    if (!epoch.truths[i].required || track_of[i] < 0) continue;
    const TrackState& track = epoch.tracks[static_cast<std::size_t>(track_of[i])];
    errors.push_back((comparable(epoch.truths[i], track).position - track.state.position).norm());
  }
  return rootMeanSquare(errors);
}

}  // namespace

void SeriesFile::openSeries(std::ostream& out) {
  series_ = &out;
  out << "tracker,t_s,ospa_m,gospa_m,gospa_loc,gospa_miss,gospa_false,completeness,required,tracks,rms_pos_m\n";
}

void SeriesFile::openPicture(std::ostream& out, double period) {
  picture_ = &out;
  period_ = period;
  out << "tracker,t_s,what,id,x_m,y_m\n";
}

void SeriesFile::add(const std::string& tracker, const Epoch& epoch, const Evaluator& evaluator) {
  if (series_ != nullptr && evaluator.epochs() > 0) addSeries(tracker, epoch, evaluator);
  double& next = next_.try_emplace(tracker, -kForever).first->second;
  if (picture_ == nullptr || epoch.time < next) return;
  if (period_ > 0.0) next = (std::floor(epoch.time / period_) + 1.0) * period_;
  addPicture(tracker, epoch);
}

void SeriesFile::addSeries(const std::string& tracker, const Epoch& epoch, const Evaluator& evaluator) {
  const SetMetrics::Values& v = evaluator.last();
  const auto required =
      std::count_if(epoch.truths.begin(), epoch.truths.end(), [](const TruthState& truth) { return truth.required; });
  char text[400];
  std::snprintf(text, sizeof text, ",%.4f,%.3f,%.3f,%.1f,%.1f,%.1f,%.5f,%ld,%zu,%.2f\n", epoch.time, v.ospa, v.gospa,
                v.localisation, v.missed, v.false_tracks, v.completeness, static_cast<long>(required),
                epoch.tracks.size(), rmsError(epoch, evaluator.lastPairs()));
  *series_ << tracker << text;
}

void SeriesFile::addTrack(const std::string& tracker, double time, std::uint32_t id, const Eigen::Vector2d& position) {
  if (picture_ != nullptr) addPlace(tracker, time, "track", id, position);
}

void SeriesFile::addPlace(const std::string& tracker, double time, const char* what, std::uint32_t id,
                          const Eigen::Vector2d& position) {
  char text[200];
  std::snprintf(text, sizeof text, ",%.4f,%s,%u,%.1f,%.1f\n", time, what, id, position.x(), position.y());
  *picture_ << tracker << text;
}

void SeriesFile::addPicture(const std::string& tracker, const Epoch& epoch) {
  const bool flat =
      std::any_of(epoch.tracks.begin(), epoch.tracks.end(), [](const TrackState& track) { return !track.has_height; });
  for (const TruthState& truth : epoch.truths)
    addPlace(tracker, epoch.time, truth.required ? "required" : "tolerated", truth.id,
             (flat ? truth.slant : truth.ground).position);
  for (const TrackState& track : epoch.tracks) addPlace(tracker, epoch.time, "track", track.id, track.state.position);
}

}  // namespace track_evaluation
