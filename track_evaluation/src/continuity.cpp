#include "continuity.h"

#include <algorithm>
#include <cmath>

namespace track_evaluation {

void Continuity::add(const Epoch& epoch, const std::vector<int>& track_of, const std::vector<bool>& excused,
                     bool counted) {
  if (!std::isnan(last_time_)) steps_.add(epoch.time - last_time_);
  last_time_ = epoch.time;
  if (counted) epochs_ += 1.0;
  std::vector<bool> paired(epoch.tracks.size(), false);
  for (std::size_t i = 0; i < epoch.truths.size(); ++i) {
    const TruthState& truth = epoch.truths[i];
    Life& life = truths_[truth.id];
    if (truth.required && std::isnan(life.first_required)) life.first_required = epoch.time;
    if (truth.required && counted) {
      required_ += 1.0;
      life.epochs += 1.0;
    }
    if (track_of[i] < 0) {
      addUnpaired(life, truth.required, counted);
      continue;
    }
    const auto track = static_cast<std::size_t>(track_of[i]);
    paired[track] = true;
    addPair(life, epoch.time, epoch.tracks[track].id, counted && truth.required);
  }
  for (std::size_t j = 0; counted && j < epoch.tracks.size(); ++j) {
    Use& use = tracks_[epoch.tracks[j].id];
    ++use.lived;
    if (paired[j] || excused[j]) ++use.paired;
    if (!paired[j] && !excused[j]) false_ += 1.0;
  }
}

void Continuity::addPair(Life& life, double time, std::uint32_t track, bool counted) {
  if (std::isnan(life.found)) life.found = time;
  if (counted) {
    if (life.ever_paired && life.last_track != track) swaps_ += 1.0;
    if (life.lost) breaks_ += 1.0;
    life.segment = life.segment_track == track ? life.segment + 1.0 : 1.0;
    life.segment_track = track;
    life.longest_segment = std::max(life.longest_segment, life.segment);
  }
  life.ever_paired = true;
  life.last_track = track;
  life.lost = false;
}

void Continuity::addUnpaired(Life& life, bool required, bool counted) {
  if (!required) return;
  if (counted) misses_ += 1.0;
  life.lost = life.ever_paired;
  life.segment = 0.0;
}

double Continuity::truthHours() const {
  // As many truths as there were on average, for as long as the evaluated interval was.
  return required_ / std::max(epochs_, 1.0) * std::max(epochs_ - 1.0, 1.0) * steps_.percentile(50.0) / 3600.0;
}

void Continuity::report(MetricList& metrics) const {
  double unused = 0.0, mostly_unused = 0.0, longest = 0.0, epochs = 0.0;
  for (const auto& [id, use] : tracks_) {
    unused += use.paired == 0 ? 1.0 : 0.0;
    mostly_unused += 2 * use.paired < use.lived ? 1.0 : 0.0;
  }
  double truths = 0.0;
  for (const auto& [id, life] : truths_) {
    truths += std::isnan(life.first_required) ? 0.0 : 1.0;
    longest += life.longest_segment;
    epochs += life.epochs;
  }
  metrics.insert(metrics.end(), {{"truths", truths},
                                 {"track_ids", static_cast<double>(tracks_.size())},
                                 {"swaps", swaps_},
                                 {"breaks", breaks_},
                                 {"swaps_per_truth_hour", ratio(swaps_, truthHours())},
                                 {"longest_segment", ratio(longest, epochs)},
                                 {"spurious_tracks", unused},
                                 {"mostly_spurious", mostly_unused},
                                 {"mota", required_ > 0.0 ? 1.0 - (misses_ + false_ + swaps_) / required_ : kUnknown}});
  reportInitiation(metrics);
}

void Continuity::reportInitiation(MetricList& metrics) const {
  std::vector<double> delays;
  double never = 0.0, judged = 0.0, in_time = 0.0;
  for (const auto& [id, life] : truths_) {
    if (std::isnan(life.first_required)) continue;
    const double delay = std::max(0.0, life.found - life.first_required);
    if (std::isnan(life.found))
      never += 1.0;
    else
      delays.push_back(delay);
    if (life.first_required + initiation_limit_ > last_time_) continue;
    judged += 1.0;
    if (!std::isnan(life.found) && delay <= initiation_limit_) in_time += 1.0;
  }
  metrics.insert(metrics.end(), {{"init_delay_med_s", percentile(delays, 50.0)},
                                 {"init_delay_p90_s", percentile(delays, 90.0)},
                                 {"initiated_in_time", ratio(in_time, judged)},
                                 {"never_tracked", never}});
}

}  // namespace track_evaluation
