#include "evaluator.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace track_evaluation {
namespace {

template <class States>
void checkOnce(const States& states, const std::string& what, double time) {
  std::vector<std::uint32_t> ids;
  ids.reserve(states.size());
  for (const auto& state : states) ids.push_back(state.id);
  std::sort(ids.begin(), ids.end());
  const auto twice = std::adjacent_find(ids.begin(), ids.end());
  if (twice != ids.end())
    throw std::invalid_argument(what + " " + std::to_string(*twice) + " comes twice at " + std::to_string(time) + " s");
}

}  // namespace

Evaluator::Evaluator(const EvaluatorParams& params, std::vector<RequirementProfile> profiles)
    : params_(params),
      matcher_(params.cutoff),
      sets_(params.cutoff, params.order),
      continuity_(params.initiation_limit),
      accuracy_(params.nees_age) {
  for (RequirementProfile& profile : profiles) requirements_.emplace_back(std::move(profile));
}

void Evaluator::check(const Epoch& epoch) const {
  if (!(epoch.time > last_time_))
    throw std::invalid_argument("epoch at " + std::to_string(epoch.time) + " s does not come after the one at " +
                                std::to_string(last_time_) + " s");
  checkOnce(epoch.truths, "truth", epoch.time);
  checkOnce(epoch.tracks, "track", epoch.time);
}

void Evaluator::add(const Epoch& epoch) {
  check(epoch);
  last_time_ = epoch.time;
  distances_.compute(epoch);
  track_of_ = matcher_.match(epoch, distances_);
  sort(epoch);
  const bool counted = epoch.time >= params_.from && epoch.time <= params_.to;
  continuity_.add(epoch, track_of_, excused_, counted);
  if (!counted) return;
  ++epochs_;
  sets_.add(epoch, distances_, required_, judged_);
  for (const std::size_t i : required_)
    if (track_of_[i] != Matcher::kNone)
      accuracy_.add(epoch.truths[i], epoch.tracks[static_cast<std::size_t>(track_of_[i])]);
  for (RequirementCounter& requirement : requirements_) requirement.add(epoch, track_of_, excused_);
}

/// Who counts: required truths, and tracks that do not follow one that is not.
void Evaluator::sort(const Epoch& epoch) {
  required_.clear();
  judged_.clear();
  excused_.assign(epoch.tracks.size(), false);
  std::vector<bool> paired(epoch.tracks.size(), false);
  for (std::size_t i = 0; i < epoch.truths.size(); ++i) {
    if (epoch.truths[i].required) required_.push_back(i);
    if (track_of_[i] == Matcher::kNone) continue;
    paired[static_cast<std::size_t>(track_of_[i])] = true;
    excused_[static_cast<std::size_t>(track_of_[i])] = !epoch.truths[i].required;
  }
  for (std::size_t j = 0; j < epoch.tracks.size(); ++j) {
    double nearest = params_.cutoff;
    for (std::size_t i = 0; i < epoch.truths.size() && !paired[j]; ++i) {
      if (distances_.at(i, j) >= nearest) continue;
      nearest = distances_.at(i, j);
      excused_[j] = !epoch.truths[i].required;
    }
    if (!excused_[j]) judged_.push_back(j);
  }
}

MetricList Evaluator::metrics() const {
  MetricList metrics;
  sets_.report(metrics);
  continuity_.report(metrics);
  accuracy_.report(metrics);
  return metrics;
}

std::vector<RequirementRow> Evaluator::requirements() const {
  std::vector<RequirementRow> rows;
  for (const RequirementCounter& requirement : requirements_) requirement.report(rows);
  return rows;
}

}  // namespace track_evaluation
