#include "requirements.h"

#include <algorithm>
#include <cmath>

#include "metric_list.h"

namespace track_evaluation {

void RequirementCounter::add(const Epoch& epoch, const std::vector<int>& track_of, const std::vector<bool>& excused) {
  std::vector<bool> paired(epoch.tracks.size(), false);
  for (std::size_t i = 0; i < epoch.truths.size(); ++i) {
    const TruthState& truth = epoch.truths[i];
    if (track_of[i] >= 0) paired[static_cast<std::size_t>(track_of[i])] = true;
    if (!truth.required) continue;
    Watch& watch = watches_[truth.id];
    if (watch.open && watch.end != last_epoch_) close(watch, counts_);
    if (!watch.open) watch = {epoch.time, epoch.time, epoch.time, true};
    watch.end = epoch.time;
    if (track_of[i] >= 0) addUpdate(watch, truth, epoch.tracks[static_cast<std::size_t>(track_of[i])], epoch.time);
  }
  for (std::size_t j = 0; j < epoch.tracks.size(); ++j) {
    reports_ += excused[j] ? 0.0 : 1.0;
    false_ += excused[j] || paired[j] ? 0.0 : 1.0;
  }
  last_epoch_ = epoch.time;
}

void RequirementCounter::addUpdate(Watch& watch, const TruthState& truth, const TrackState& track, double time) {
  squares_ += (comparable(truth, track).position - track.state.position).squaredNorm();
  pairs_ += 1.0;
  const double update = std::isnan(track.last_update) ? time : track.last_update;
  if (update <= watch.last_update && watch.last_update > watch.begin) return;
  addGap(counts_, update - watch.last_update);
  watch.last_update = std::max(update, watch.last_update);
  codes_reported_ = codes_reported_ || track.mode_3a != kCodeUnknown;
  heights_reported_ = heights_reported_ || !std::isnan(track.height);
  if (truth.mode_3a != kCodeUnknown) {
    coded_ += 1.0;
    right_code_ += track.mode_3a == truth.mode_3a ? 1.0 : 0.0;
  }
  if (!std::isnan(truth.height)) {
    high_ += 1.0;
    right_height_ += std::abs(track.height - truth.height) <= profile_.height_error ? 1.0 : 0.0;
  }
}

void RequirementCounter::addGap(Counts& counts, double length) const {
  if (length > 0.0) counts.missed += std::ceil(length / profile_.update_interval) - 1.0;
  if (length > profile_.long_gap) counts.long_gaps += 1.0;
}

void RequirementCounter::close(Watch& watch, Counts& counts) const {
  addGap(counts, watch.end - watch.last_update);
  counts.expected += std::floor((watch.end - watch.begin) / profile_.update_interval);
  watch.open = false;
}

void RequirementCounter::report(std::vector<RequirementRow>& rows) const {
  Counts counts = counts_;
  for (const auto& [id, watch] : watches_) {
    Watch last = watch;
    if (last.open) close(last, counts);
  }
  const auto row = [&](const char* name, const char* unit, double value, double limit, bool at_least) {
    if (!std::isnan(limit)) rows.push_back({profile_.name, name, unit, value, limit, at_least});
  };
  row("probability of update", "", 1.0 - ratio(counts.missed, counts.expected), profile_.update_probability, true);
  row("long gaps", "", ratio(counts.long_gaps, counts.expected), profile_.long_gap_share, false);
  row("horizontal RMS", "m", std::sqrt(ratio(squares_, pairs_)), profile_.horizontal_rms, false);
  row("false track reports", "", ratio(false_, reports_), profile_.false_share, false);
  row("Mode 3/A detection", "", codes_reported_ ? ratio(right_code_, coded_) : kUnknown, profile_.mode_3a_probability,
      true);
  row("Mode C detection", "", heights_reported_ ? ratio(right_height_, high_) : kUnknown, profile_.mode_c_probability,
      true);
}

}  // namespace track_evaluation
