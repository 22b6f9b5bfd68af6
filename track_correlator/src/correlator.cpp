#include "correlator.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <tws_core/geometry.h>
#include <tws_core/sectors.h>

namespace track_correlator {
namespace {

constexpr std::int64_t kLongestGap = std::int64_t{8} * tws::kSectors;
constexpr std::int64_t kHalfTurn = tws::kSectors / 2;

void check(bool good, const char* rule) {
  if (!good) throw std::invalid_argument(std::string("correlator: ") + rule);
}

}  // namespace

Correlator::Correlator(const CorrelatorParams& params, OnReport on_report)
    : params_(params), on_report_(std::move(on_report)), table_(params.fusion) {
  check(params.delay_sectors >= 2 && params.delay_sectors <= 32, "delay_sectors must be in 2 .. 32");
  check(params.gate > 0.0 && params.position_bias >= 0.0 && params.velocity_bias >= 0.0,
        "gate must be above 0, position_bias and velocity_bias not negative");
  check(params.fusion.initiate_above >= 0 && params.fusion.clear_scans >= 1 && params.fusion.parallel_scans >= 1,
        "initiate_above must not be negative, clear_scans and parallel_scans at least 1");
  check(params.release_distance >= 0.0 && params.release_scans >= 1, "release_distance must not be negative");
  check(params.track_timeout > 0.0, "track_timeout must be above 0");
}

void Correlator::addPrimary(const TrackInput& track) {
  if (track.dropped)
    losePrimary(track.uid);
  else
    primaries_[track.uid].input = track;
}

void Correlator::addSecondary(const TrackInput& track) {
  if (track.dropped)
    loseSecondary(track.uid);
  else
    secondaries_[track.uid].input = track;
}

void Correlator::losePrimary(std::uint32_t uid) {
  const auto found = primaries_.find(uid);
  if (found == primaries_.end()) return;
  const std::uint32_t identity = found->second.identity;
  primaries_.erase(found);
  const FusionRow* row = table_.ofPrimary(uid);
  const std::uint32_t partner = row == nullptr ? kNoTrack : row->secondary;
  if (table_.losePrimary(uid)) end(identity, uid, partner);
}

void Correlator::loseSecondary(std::uint32_t uid) {
  const auto found = secondaries_.find(uid);
  if (found == secondaries_.end()) return;
  const std::uint32_t identity = found->second.identity;
  secondaries_.erase(found);
  const FusionRow* row = table_.ofSecondary(uid);
  const std::uint32_t partner = row == nullptr ? kNoTrack : row->primary;
  if (table_.loseSecondary(uid)) end(identity, partner, uid);
}

/// An identity that nobody has heard of needs no last word.
void Correlator::end(std::uint32_t identity, std::uint32_t primary, std::uint32_t secondary) {
  if (identity == 0) return;
  CorrelatedWord word;
  word.identity = identity;
  word.primary = primary;
  word.secondary = secondary;
  word.correlated = primary != kNoTrack && secondary != kNoTrack;
  word.ended = true;
  ended_.push_back(word);
}

void Correlator::addMark(std::int64_t running, double time) {
  const std::int64_t gap = marks_.empty() ? 1 : running - marks_.back().running;
  if (gap <= 0 || gap > kLongestGap) {
    const bool new_count = stray_ && running == *stray_ + 1;
    stray_ = running;
    if (!new_count) {
      ++counts_.stray_marks;
      return;
    }
    // The radar counts anew: scans are told from the new count on.
    marks_.clear();
    table_ = FusionTable(params_.fusion);
    for (Tracks* tracks : {&primaries_, &secondaries_})
      for (auto& [uid, track] : *tracks) track.done = track.taken = running - tws::kSectors;
  }
  stray_.reset();
  if (!marks_.empty()) {
    const Mark last = marks_.back();
    for (std::int64_t n = 1; n < gap; ++n) {
      ++counts_.lost_marks;
      const double part = static_cast<double>(n) / static_cast<double>(gap);
      enter({last.running + n, last.time + part * (time - last.time)});
    }
  }
  enter({running, time});
}

/// Δ₂ sectors behind the beam.
void Correlator::enter(const Mark& mark) {
  marks_.push_back(mark);
  if (marks_.size() <= static_cast<std::size_t>(params_.delay_sectors)) return;
  process(marks_.front());
  marks_.erase(marks_.begin());
}

/// Figure 3.
void Correlator::process(const Mark& mark) {
  loseSilentTracks(mark.time);
  bringTo(mark, primaries_);
  bringTo(mark, secondaries_);
  clearExpired(primaries_, true, mark.running);
  clearExpired(secondaries_, false, mark.running);
  if (params_.fusion.scheme == Scheme::kDistance)
    forgetHistory(mark.running);
  else
    correlateByHistory(mark.running);
  correlateByDistance(mark.running);
  report(mark);
}

void Correlator::loseSilentTracks(double time) {
  std::vector<std::uint32_t> silent;
  const auto find = [&](const Tracks& tracks) {
    silent.clear();
    for (const auto& [uid, track] : tracks)
      if (time - track.input.time > params_.track_timeout) silent.push_back(uid);
    counts_.silent_tracks += silent.size();
  };
  find(primaries_);
  for (const std::uint32_t uid : silent) losePrimary(uid);
  find(secondaries_);
  for (const std::uint32_t uid : silent) loseSecondary(uid);
}

void Correlator::bringTo(const Mark& mark, Tracks& tracks) {
  const int sector = static_cast<int>(mark.running % tws::kSectors);
  for (auto& [uid, track] : tracks) {
    track.now = track.input.state;
    track.now.head<2>() += (mark.time - track.input.time) * track.input.state.tail<2>();
    track.behind = tws::sectorDifference(sector, tws::sectorOf(tws::azimuthOf(track.now.head<2>())));
  }
}

/// Once a turn; one or two sectors behind: it has moved against the beam, out of a sector that was still to come.
bool Correlator::isDue(const Known& track, std::int64_t running) const {
  return track.behind >= 0 && track.behind <= 2 && running - track.done >= kHalfTurn;
}

void Correlator::clearExpired(const Tracks& tracks, bool primaries, std::int64_t running) {
  for (const auto& [uid, track] : tracks) {
    if (!isDue(track, running)) continue;
    const FusionRow* row = primaries ? table_.ofPrimary(uid) : table_.ofSecondary(uid);
    if (row == nullptr || !table_.expired(*row, running)) continue;
    dissolve(row);
    ++counts_.cleared;
  }
}

/// The table first: a pair in it stays a pair, within its threshold (subroutine 1) or not (subroutine 2).
void Correlator::correlateByHistory(std::int64_t running) {
  for (auto& [uid, primary] : primaries_) {
    if (!isDue(primary, running)) continue;
    FusionRow* row = table_.ofPrimary(uid);
    if (row == nullptr || row->secondary_lost) continue;
    Known& secondary = secondaries_.at(row->secondary);
    const double apart = (primary.now - secondary.now).head<2>().norm();
    const bool outside = params_.release_distance > 0.0 && apart > params_.release_distance;
    row->outside = outside ? row->outside + 1 : 0;
    if (row->outside < params_.release_scans) {
      table_.update(*row, running);
      secondary.taken = running;
      continue;
    }
    dissolve(row);
    ++counts_.released;
  }
}

/// A track may look for a partner when it has none; in the plain scheme only when its row has been cleared.
bool Correlator::isFree(const FusionRow* row) const {
  if (row == nullptr || params_.fusion.scheme == Scheme::kDistance) return true;
  return params_.fusion.scheme == Scheme::kParallelCounter && (row->primary_lost || row->secondary_lost);
}

void Correlator::correlateByDistance(std::int64_t running) {
  // Primaries of the next sector compete: what is nearer to them is left to them.
  std::vector<std::pair<std::uint32_t, const Known*>> primaries, secondaries;
  for (const auto& [uid, track] : primaries_) {
    const bool rival = track.behind == -1 && running - track.done >= kHalfTurn;
    if ((rival || isDue(track, running)) && isFree(table_.ofPrimary(uid))) primaries.emplace_back(uid, &track);
  }
  for (const auto& [uid, track] : secondaries_) {
    const bool near = std::abs(track.behind) <= 1 && running - track.taken >= kHalfTurn;
    if (near && isFree(table_.ofSecondary(uid))) secondaries.emplace_back(uid, &track);
  }
  std::vector<GatedPair> pairs;
  for (std::uint32_t p = 0; p < primaries.size(); ++p) {
    for (std::uint32_t s = 0; s < secondaries.size(); ++s) {
      const double d = distance(*primaries[p].second, *secondaries[s].second);
      if (d <= params_.gate) pairs.push_back({p, s, d});
    }
  }
  for (const GatedPair& pair : association_.solve(pairs, primaries.size(), secondaries.size(), params_.gate)) {
    if (isDue(*primaries[pair.primary].second, running))
      commit(primaries[pair.primary].first, secondaries[pair.secondary].first, running);
  }
  counts_.clusters += association_.clusters();
}

/// Position and velocity, each by its own errors: (a - b)ᵀ·(P_a + P_b + bias)⁻¹·(a - b).
double Correlator::distance(const Known& primary, const Known& secondary) const {
  const Eigen::Vector4d apart = primary.now - secondary.now;
  Eigen::Matrix4d covariance = primary.input.covariance + secondary.input.covariance;
  const double position = params_.position_bias * params_.position_bias;
  const double velocity = params_.velocity_bias * params_.velocity_bias;
  covariance.diagonal() += Eigen::Vector4d(position, position, velocity, velocity);
  return apart.dot(covariance.llt().solve(apart));
}

void Correlator::commit(std::uint32_t primary, std::uint32_t secondary, std::int64_t running) {
  secondaries_.at(secondary).taken = running;
  if (params_.fusion.scheme == Scheme::kDistance) dissolve(table_.ofSecondary(secondary));
  const bool primary_goes_on = table_.ofPrimary(primary) != nullptr;
  const FusionTable::Outcome outcome = table_.correlate(primary, secondary, running);
  const std::uint32_t of_primary = primaries_.at(primary).identity, of_secondary = secondaries_.at(secondary).identity;
  if (outcome == FusionTable::Outcome::kInitiated) {
    ++counts_.initiated;
    settleIdentity(primary, secondary, of_secondary == 0 || (of_primary != 0 && of_primary < of_secondary));
  } else if (outcome == FusionTable::Outcome::kTakenOver) {
    ++counts_.taken_over;
    settleIdentity(primary, secondary, primary_goes_on);
  }
}

/// Two have become one aircraft: one identity ends. The older one stays, or that of the row whose lost track is
/// replaced.
void Correlator::settleIdentity(std::uint32_t primary, std::uint32_t secondary, bool primarys) {
  Known& p = primaries_.at(primary);
  Known& s = secondaries_.at(secondary);
  const std::uint32_t other = primarys ? s.identity : p.identity;
  if (p.identity != s.identity) end(other, primarys ? kNoTrack : primary, primarys ? secondary : kNoTrack);
  p.identity = s.identity = primarys ? p.identity : s.identity;
}

/// The pair is one no more; the primary keeps the identity.
void Correlator::dissolve(const FusionRow* row) {
  if (row == nullptr) return;
  if (!row->secondary_lost && !row->primary_lost) secondaries_.at(row->secondary).identity = 0;
  table_.remove(*row);
}

void Correlator::forgetHistory(std::int64_t running) {
  for (auto& [uid, primary] : primaries_)
    if (isDue(primary, running)) dissolve(table_.ofPrimary(uid));
}

bool Correlator::holds(bool primary, std::uint32_t uid) const {
  const Tracks& tracks = primary ? primaries_ : secondaries_;
  const FusionRow* row = primary ? table_.ofPrimary(uid) : table_.ofSecondary(uid);
  return tracks.count(uid) > 0 || row != nullptr || std::any_of(ended_.begin(), ended_.end(), [&](const auto& word) {
           return (primary ? word.primary : word.secondary) == uid;
         });
}

std::uint32_t Correlator::identityOf(Known& track) {
  if (track.identity == 0) track.identity = ++last_identity_;
  return track.identity;
}

CorrelatedWord Correlator::wordOf(const FusionRow& row, std::uint32_t identity) const {
  CorrelatedWord word;
  word.identity = identity;
  word.primary = row.primary;
  word.secondary = row.secondary;
  word.correlated = true;
  word.coasting = row.primary_lost || row.secondary_lost;
  word.scan_count = row.last / tws::kSectors;
  word.fusion_count = row.fusion_count;
  return word;
}

void Correlator::report(const Mark& mark) {
  CorrelatorReport report{mark.running, mark.time, std::move(ended_)};
  ended_.clear();
  for (auto& [uid, track] : primaries_) {
    if (!isDue(track, mark.running)) continue;
    track.done = mark.running;
    const FusionRow* row = table_.ofPrimary(uid);
    const std::uint32_t identity = identityOf(track);
    if (row != nullptr && !row->secondary_lost) secondaries_.at(row->secondary).identity = identity;
    CorrelatedWord alone;
    alone.identity = identity;
    alone.primary = uid;
    report.words.push_back(row == nullptr ? alone : wordOf(*row, identity));
  }
  for (auto& [uid, track] : secondaries_) {
    if (!isDue(track, mark.running)) continue;
    track.done = mark.running;
    const FusionRow* row = table_.ofSecondary(uid);
    if (row != nullptr && !row->primary_lost) continue;  // The primary speaks for both.
    CorrelatedWord alone;
    alone.identity = identityOf(track);
    alone.secondary = uid;
    report.words.push_back(row == nullptr ? alone : wordOf(*row, track.identity));
  }
  on_report_(report);
}

}  // namespace track_correlator
