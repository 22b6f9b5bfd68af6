#include "core/cluster_weigher.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace adit_tracker {
namespace {

constexpr double kSurelyOwn = 0.05;  // a miss is so much less likely than the only detection: nothing to weigh
constexpr double kUsedUp = 1e-6;     // of a detection: less is not left to anybody
constexpr double kGreatestOdds = 1e9;

/// A track as the detections see it.
struct Chances {
  double exists, seen, missed;  // there; there and detected; there, if it is not detected
};

Chances chancesOf(const Track& track) {
  const double exists = track.existence, seen = exists * track.detectionChance();
  return {exists, seen, (exists - seen) / (1.0 - seen)};
}

double oddsOf(const Chances& chances, const Candidate& candidate) {
  const Detection& detection = *candidate.detection;
  const double ratio = candidate.likelihood / detection.false_density;
  return std::min(kGreatestOdds, detection.left * chances.seen * ratio / (1.0 - chances.seen));
}

bool areInOneCell(const ClusterWeigher::Resolution& cell, const Prediction& a, const Prediction& b) {
  return std::abs(a.range - b.range) < cell.range &&
         std::abs(tws::angularDifference(a.azimuth, b.azimuth)) < cell.azimuth;
}

void give(Detection& detection, const Entry& entry, std::uint64_t run) {
  detection.taker = entry.slot;
  detection.promised = !entry.primary;
  if (!entry.primary) detection.flagged_in = run;
}

}  // namespace

std::size_t ClusterWeigher::rootOf(std::size_t entry) {
  while (roots_[entry] != entry) entry = roots_[entry] = roots_[roots_[entry]];
  return entry;
}

/// Entries that want one detection belong together.
void ClusterWeigher::join(const Run& run) {
  roots_.resize(run.entries.size());
  for (std::size_t e = 0; e < roots_.size(); ++e) {
    roots_[e] = e;
    for (std::size_t i = run.entries[e].first; i < run.entries[e].last; ++i) {
      Detection& detection = *run.candidates[i].detection;
      if (detection.askers++ == 0) {
        detection.asked_by = static_cast<std::uint32_t>(e);
        continue;
      }
      const std::size_t a = rootOf(e), b = rootOf(detection.asked_by);
      roots_[std::max(a, b)] = std::min(a, b);
    }
  }
  for (std::size_t e = 0; e < roots_.size(); ++e) roots_[e] = rootOf(e);
}

bool ClusterWeigher::takeAlone(const Run& run, Entry& entry) {
  if (entry.last - entry.first != 1) return false;
  const Candidate& candidate = run.candidates[entry.first];
  Detection& detection = *candidate.detection;
  if (detection.askers != 1 || detection.left < 1.0) return false;
  const Chances chances = chancesOf(run.tracks.at(entry.slot));
  const double odds = oddsOf(chances, candidate);
  if (chances.missed > kSurelyOwn * odds) return false;
  entry.correlated = true;
  give(detection, entry, run.number);
  if (entry.primary) {
    detection.used = true;
    detection.left = 1.0 / (1.0 + odds);
    run.correlations.push_back({entry.slot, &detection});
  }
  return true;
}

/// Who may have made which plot.
void ClusterWeigher::pair(const Run& run, const std::size_t* begin, const std::size_t* end) {
  pairings_.clear();
  plots_.clear();
  for (const auto* e = begin; e != end; ++e) {
    const Entry& entry = run.entries[*e];
    const Chances chances = chancesOf(run.tracks.at(entry.slot));
    for (std::size_t i = entry.first; i < entry.last; ++i) {
      Detection& detection = *run.candidates[i].detection;
      if (detection.index == Detection::kNoIndex) {
        detection.index = static_cast<std::uint32_t>(plots_.size());
        plots_.push_back(&detection);
      }
      pairings_.push_back({static_cast<std::size_t>(e - begin), detection.index, oddsOf(chances, run.candidates[i])});
    }
  }
}

/// For each firm track: is there another one in its cell, and which of its plots did that one make?
void ClusterWeigher::hideInOthers(const Run& run, const std::size_t* begin) {
  const auto trackOf = [&](const Pairing& p) -> const Track& {
    return run.tracks.at(run.entries[begin[p.track]].slot);
  };
  claims_.clear();
  for (std::size_t i = 0; i < pairings_.size(); ++i) {
    if (trackOf(pairings_[i]).firm) claims_.push_back(i);
  }
  for (const std::size_t i : claims_) {
    for (const std::size_t j : claims_) {
      const Pairing &a = pairings_[i], &b = pairings_[j];
      if (a.plot == b.plot && a.track != b.track &&
          areInOneCell(run.resolution, trackOf(a).predicted, trackOf(b).predicted))
        outcomes_[a.track].hidden += run.resolution.merged * b.chance;
    }
  }
}

/// A track that may be hidden in another one's plot is hardly missed.
void ClusterWeigher::existAfter(const Run& run, const std::size_t* begin, const std::size_t* end) {
  outcomes_.assign(static_cast<std::size_t>(end - begin), {0.0, 0.0, 0.0, nullptr});
  spoken_for_.assign(plots_.size(), 0.0);
  for (const Pairing& p : pairings_) {
    outcomes_[p.track].existence += p.chance;
    spoken_for_[p.plot] += p.chance;
  }
  if (run.resolution.merged > 0.0) hideInOthers(run, begin);
  for (std::size_t e = 0; e < outcomes_.size(); ++e) {
    Outcome& o = outcomes_[e];
    const Chances chances = chancesOf(run.tracks.at(run.entries[begin[e]].slot));
    const double none = std::max(0.0, 1.0 - o.existence);
    o.missed = none * chances.missed;
    o.existence += o.missed;
    o.hidden = none * std::min(o.hidden, 1.0) * chances.seen / (1.0 - chances.seen);
  }
}

/// A track takes the plot that is rather its own than not. What was rather made by one of several firm tracks, nobody
/// can say by which, is taken by the likeliest of them that has no other.
void ClusterWeigher::chooseTakers(const Run& run, const std::size_t* begin) {
  claims_.clear();
  const auto isOwn = [&](const Pairing& p) { return p.chance > 0.5 * outcomes_[p.track].existence; };
  const auto mayInherit = [&](const Pairing& p) {
    const bool is_free = plots_[p.plot]->taker == Detection::kNoTaker || plots_[p.plot]->left >= 0.5;
    return is_free && spoken_for_[p.plot] > 0.5 && run.tracks.at(run.entries[begin[p.track]].slot).firm;
  };
  for (std::size_t i = 0; i < pairings_.size(); ++i) {
    if (isOwn(pairings_[i]) || mayInherit(pairings_[i])) claims_.push_back(i);
  }
  std::stable_sort(claims_.begin(), claims_.end(),
                   [&](auto a, auto b) { return pairings_[a].chance > pairings_[b].chance; });
  for (const std::size_t i : claims_) {
    const Pairing& p = pairings_[i];
    Detection& detection = *plots_[p.plot];
    if (outcomes_[p.track].taken != nullptr || detection.taken_in == run.number) continue;
    outcomes_[p.track].taken = &detection;
    detection.taken_in = run.number;
    give(detection, run.entries[begin[p.track]], run.number);
  }
}

/// `pairing`: its first, then the next one's.
void ClusterWeigher::settle(const Run& run, std::size_t number, const Outcome& outcome, std::size_t& pairing) {
  Entry& entry = run.entries[number];
  const std::size_t first = pairing;
  pairing += entry.last - entry.first;
  entry.correlated = outcome.taken != nullptr;
  if (!entry.primary) return;
  Correlation result{entry.slot, outcome.taken, true};
  result.first = chances_.size();
  for (std::size_t i = first; i < pairing; ++i)
    chances_.push_back({plots_[pairings_[i].plot], pairings_[i].chance / outcome.existence});
  result.last = chances_.size();
  result.existence = (outcome.existence + outcome.hidden) / (1.0 + outcome.hidden);
  result.unhidden = outcome.existence;
  result.missed = outcome.missed / outcome.existence;
  result.cluster = roots_[number];
  run.correlations.push_back(result);
}

/// Secondary tracks have only competed: they will take theirs when it is their turn, and what is left to them is what
/// it would be without them.
void ClusterWeigher::leaveToOthers(const Run& run, const std::size_t* begin) {
  spoken_for_.assign(plots_.size(), 0.0);
  for (const Pairing& p : pairings_) {
    if (run.entries[begin[p.track]].primary) spoken_for_[p.plot] += p.claim;
  }
  for (std::size_t p = 0; p < plots_.size(); ++p) {
    plots_[p]->left /= 1.0 + spoken_for_[p];
    if (plots_[p]->left < kUsedUp) plots_[p]->used = true;
  }
}

void ClusterWeigher::solve(const Run& run, const std::size_t* begin, const std::size_t* end) {
  pair(run, begin, end);
  solver_.solve(pairings_);
  existAfter(run, begin, end);
  chooseTakers(run, begin);
  std::size_t pairing = 0;
  for (const auto* e = begin; e != end; ++e) settle(run, *e, outcomes_[static_cast<std::size_t>(e - begin)], pairing);
  leaveToOthers(run, begin);
}

void ClusterWeigher::weigh(const TrackFile& tracks, std::vector<Entry>& entries,
                           const std::vector<Candidate>& candidates, const Resolution& resolution, std::uint64_t number,
                           std::vector<Correlation>& correlations) {
  const Run run{tracks, entries, candidates, resolution, number, correlations};
  chances_.clear();
  ambiguous_.clear();
  join(run);
  for (std::size_t e = 0; e < entries.size(); ++e) {
    if (!takeAlone(run, entries[e])) ambiguous_.push_back(e);
  }
  std::stable_sort(ambiguous_.begin(), ambiguous_.end(), [&](auto a, auto b) { return roots_[a] < roots_[b]; });
  for (std::size_t first = 0, last = 0; first < ambiguous_.size(); first = last) {
    while (last < ambiguous_.size() && roots_[ambiguous_[last]] == roots_[ambiguous_[first]]) ++last;
    solve(run, ambiguous_.data() + first, ambiguous_.data() + last);
  }
}

}  // namespace adit_tracker
