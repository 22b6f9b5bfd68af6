#include "matcher.h"

namespace track_evaluation {

const std::vector<int>& Matcher::match(const Epoch& epoch, const Distances& distances) {
  track_of_.assign(epoch.truths.size(), kNone);
  taken_.assign(epoch.tracks.size(), false);
  keepPairs(epoch, distances);
  assignRest(epoch, distances);
  last_.clear();
  for (std::size_t i = 0; i < track_of_.size(); ++i) {
    if (track_of_[i] != kNone) last_[epoch.truths[i].id] = epoch.tracks[static_cast<std::size_t>(track_of_[i])].id;
  }
  return track_of_;
}

void Matcher::keepPairs(const Epoch& epoch, const Distances& distances) {
  std::map<std::uint32_t, std::size_t> place;
  for (std::size_t j = 0; j < epoch.tracks.size(); ++j) place[epoch.tracks[j].id] = j;
  for (std::size_t i = 0; i < epoch.truths.size(); ++i) {
    const auto before = last_.find(epoch.truths[i].id);
    if (before == last_.end()) continue;
    const auto now = place.find(before->second);
    if (now == place.end() || distances.at(i, now->second) >= cutoff_) continue;
    track_of_[i] = static_cast<int>(now->second);
    taken_[now->second] = true;
  }
}

void Matcher::assignRest(const Epoch& epoch, const Distances& distances) {
  free_truths_.clear();
  free_tracks_.clear();
  for (std::size_t i = 0; i < epoch.truths.size(); ++i)
    if (track_of_[i] == kNone) free_truths_.push_back(i);
  for (std::size_t j = 0; j < epoch.tracks.size(); ++j)
    if (!taken_[j]) free_tracks_.push_back(j);
  pairs_.clear();
  for (std::uint32_t i = 0; i < free_truths_.size(); ++i) {
    for (std::uint32_t j = 0; j < free_tracks_.size(); ++j) {
      const double distance = distances.at(free_truths_[i], free_tracks_[j]);
      if (distance < cutoff_) pairs_.push_back({i, j, distance});
    }
  }
  const std::vector<int>& answer = solver_.solve(pairs_, free_truths_.size(), free_tracks_.size());
  for (std::size_t i = 0; i < answer.size(); ++i)
    if (answer[i] != kNone)
      track_of_[free_truths_[i]] = static_cast<int>(free_tracks_[static_cast<std::size_t>(answer[i])]);
}

}  // namespace track_evaluation
