#include "correlation.h"

#include <algorithm>
#include <cmath>

namespace track_evaluation {

namespace {

// Pairs are held for some time; by so much [m] a track must be nearer to another aircraft to be a track of that one.
constexpr double kNearer = 100.0;
// Between two epochs far fewer come; so many without one, and no truth is there to judge them by.
constexpr std::size_t kMostWaiting = 100000;

struct Pair {
  const TruthState* truth;
  const TrackState* track;
};

double distance(const TruthState& truth, const TrackState& track) {
  return (comparable(truth, track).position - track.state.position).norm();
}

bool isWrong(const CorrelationMetrics::Update& update, const Pair& pair, const Epoch& epoch) {
  if (update.mode_3a == pair.truth->mode_3a) return false;
  const double limit = distance(*pair.truth, *pair.track) - kNearer;
  return std::none_of(epoch.truths.begin(), epoch.truths.end(), [&](const TruthState& truth) {
    return truth.mode_3a == update.mode_3a && distance(truth, *pair.track) < limit;
  });
}

}  // namespace

void CorrelationMetrics::add(const Update& update) {
  updates_[static_cast<std::size_t>(update.kind)] += 1.0;
  if (update.kind != Kind::kCorrelated || update.mode_3a == kCodeUnknown) return;
  if (waiting_.size() >= kMostWaiting) waiting_.clear();
  waiting_.push_back(update);
}

void CorrelationMetrics::judge(const Epoch& epoch, const std::vector<int>& track_of) {
  if (std::isnan(first_time_)) first_time_ = epoch.time;
  last_time_ = epoch.time;
  std::map<std::uint32_t, Pair> pairs;  // by identity
  for (std::size_t i = 0; i < epoch.truths.size(); ++i)
    if (track_of[i] >= 0 && epoch.truths[i].mode_3a != kCodeUnknown) {
      const TrackState& track = epoch.tracks[static_cast<std::size_t>(track_of[i])];
      pairs[track.id] = {&epoch.truths[i], &track};
    }
  for (const Update& update : waiting_) {
    const auto pair = pairs.find(update.identity);
    if (pair == pairs.end()) continue;
    judged_ += 1.0;
    if (isWrong(update, pair->second, epoch)) wrong_ += 1.0;
  }
  waiting_.clear();
}

MetricList CorrelationMetrics::report() const {
  const auto of = [&](Kind kind) { return updates_[static_cast<std::size_t>(kind)]; };
  const double all = updates_[0] + updates_[1] + updates_[2];
  MetricList metrics{{"words_correlated", of(Kind::kCorrelated)},
                     {"words_primary_only", of(Kind::kPrimaryOnly)},
                     {"words_secondary_only", of(Kind::kSecondaryOnly)},
                     {"correlated_share", ratio(of(Kind::kCorrelated), all)}};
  if (std::isnan(first_time_)) return metrics;
  metrics.insert(metrics.end(), {{"judged_words", judged_},
                                 {"miscorrelations", wrong_},
                                 {"miscorrelations_per_hour", ratio(3600.0 * wrong_, last_time_ - first_time_)},
                                 {"miscorrelated_share", ratio(wrong_, judged_)}});
  return metrics;
}

}  // namespace track_evaluation
