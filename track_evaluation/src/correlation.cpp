#include "correlation.h"

#include <cmath>

namespace track_evaluation {

void CorrelationMetrics::add(const Word& word) {
  words_[static_cast<std::size_t>(word.kind)] += 1.0;
  if (word.kind == Kind::kCorrelated && word.mode_3a != kCodeUnknown) waiting_.push_back(word);
}

void CorrelationMetrics::judge(const Epoch& epoch, const std::vector<int>& track_of) {
  if (std::isnan(first_time_)) first_time_ = epoch.time;
  last_time_ = epoch.time;
  std::map<std::uint32_t, std::uint16_t> right_code;  // by identity
  for (std::size_t i = 0; i < epoch.truths.size(); ++i)
    if (track_of[i] >= 0 && epoch.truths[i].mode_3a != kCodeUnknown)
      right_code[epoch.tracks[static_cast<std::size_t>(track_of[i])].id] = epoch.truths[i].mode_3a;
  for (const Word& word : waiting_) {
    const auto right = right_code.find(word.identity);
    if (right == right_code.end()) continue;
    judged_ += 1.0;
    if (word.mode_3a != right->second) wrong_ += 1.0;
  }
  waiting_.clear();
}

MetricList CorrelationMetrics::report() const {
  const auto of = [&](Kind kind) { return words_[static_cast<std::size_t>(kind)]; };
  const double all = words_[0] + words_[1] + words_[2];
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
