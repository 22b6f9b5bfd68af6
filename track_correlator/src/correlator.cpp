#include "correlator.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include <tws_core/sectors.h>

namespace track_correlator {
namespace {

void check(bool good, const char* rule) {
  if (!good) throw std::invalid_argument(std::string("correlator: ") + rule);
}

CorrelatedUpdate updateOf(const FusionRow& row, std::uint32_t identity) {
  CorrelatedUpdate update;
  update.identity = identity;
  update.primary = row.primary;
  update.secondary = row.secondary;
  update.correlated = true;
  update.coasting = row.primary_lost || row.secondary_lost;
  update.scan_count = row.last / tws::kSectors;
  update.fusion_count = row.fusion_count;
  return update;
}

}  // namespace

Correlator::Correlator(const CorrelatorParams& params, OnReport on_report)
    : params_(params), on_report_(std::move(on_report)), table_(params.fusion), clock_(params.delay_sectors) {
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
    primaries_.add(track);
}

void Correlator::addSecondary(const TrackInput& track) {
  if (track.dropped)
    loseSecondary(track.uid);
  else
    secondaries_.add(track);
}

void Correlator::losePrimary(std::uint32_t uid) {
  const KnownTrack* track = primaries_.find(uid);
  if (track == nullptr) return;
  const std::uint32_t identity = track->identity;
  primaries_.erase(uid);
  const FusionRow* row = table_.ofPrimary(uid);
  const std::uint32_t partner = row == nullptr ? kNoTrack : row->secondary;
  if (table_.losePrimary(uid)) end(identity, uid, partner);
}

void Correlator::loseSecondary(std::uint32_t uid) {
  const KnownTrack* track = secondaries_.find(uid);
  if (track == nullptr) return;
  const std::uint32_t identity = track->identity;
  secondaries_.erase(uid);
  const FusionRow* row = table_.ofSecondary(uid);
  const std::uint32_t partner = row == nullptr ? kNoTrack : row->primary;
  if (table_.loseSecondary(uid)) end(identity, partner, uid);
}

/// An identity that was never published needs no final update.
void Correlator::end(std::uint32_t identity, std::uint32_t primary, std::uint32_t secondary) {
  if (identity == 0) return;
  CorrelatedUpdate update;
  update.identity = identity;
  update.primary = primary;
  update.secondary = secondary;
  update.correlated = primary != kNoTrack && secondary != kNoTrack;
  update.ended = true;
  ended_.push_back(update);
}

/// Δ₂ sectors behind the beam.
void Correlator::addMark(std::int64_t running, double time) {
  const MarkClock::Step step = clock_.add({running, time});
  counts_.lost_marks += step.lost;
  if (step.stray) ++counts_.stray_marks;
  if (step.restarted) {
    // Scans are counted from the new count on.
    table_ = FusionTable(params_.fusion);
    primaries_.restart(running);
    secondaries_.restart(running);
  }
  for (const Mark& mark : step.due) process(mark);
}

/// Figure 3.
void Correlator::process(const Mark& mark) {
  loseSilentTracks(mark.time);
  near_primaries_ = primaries_.nearTo(mark);
  near_secondaries_ = secondaries_.nearTo(mark);
  clearExpired(mark);
  if (params_.fusion.scheme == Scheme::kDistance)
    forgetHistory(mark.running);
  else
    correlateByHistory(mark);
  correlateByDistance(mark);
  report(mark);
}

void Correlator::loseSilentTracks(double time) {
  for (const std::uint32_t uid : primaries_.silentAt(time, params_.track_timeout)) {
    ++counts_.silent_tracks;
    losePrimary(uid);
  }
  for (const std::uint32_t uid : secondaries_.silentAt(time, params_.track_timeout)) {
    ++counts_.silent_tracks;
    loseSecondary(uid);
  }
}

void Correlator::clearExpired(const Mark& mark) {
  for (const auto& [uid, track] : near_primaries_)
    if (track->isDue(mark.running)) clearExpired(table_.ofPrimary(uid), mark.running);
  for (const auto& [uid, track] : near_secondaries_)
    if (track->isDue(mark.running)) clearExpired(table_.ofSecondary(uid), mark.running);
}

void Correlator::clearExpired(const FusionRow* row, std::int64_t running) {
  if (row == nullptr || !table_.expired(*row, running)) return;
  dissolve(row);
  ++counts_.cleared;
}

/// The table first: a pair in it stays a pair, within its threshold (subroutine 1) or not (subroutine 2).
void Correlator::correlateByHistory(const Mark& mark) {
  for (const auto& [uid, primary] : near_primaries_) {
    if (!primary->isDue(mark.running)) continue;
    FusionRow* row = table_.ofPrimary(uid);
    if (row == nullptr || row->secondary_lost) continue;
    KnownTrack& secondary = secondaries_.at(row->secondary);
    const double apart = (primary->at(mark.time) - secondary.at(mark.time)).head<2>().norm();
    const bool outside = params_.release_distance > 0.0 && apart > params_.release_distance;
    row->outside = outside ? row->outside + 1 : 0;
    if (row->outside < params_.release_scans) {
      table_.update(*row, mark.running);
      secondary.taken = mark.running;
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

void Correlator::correlateByDistance(const Mark& mark) {
  // Primaries of the next sector compete: what is nearer to them is left to them.
  KnownTracks::Near primaries, secondaries;
  for (const auto& [uid, track] : near_primaries_) {
    const bool rival = track->behind == -1 && track->isFresh(mark.running);
    if ((rival || track->isDue(mark.running)) && isFree(table_.ofPrimary(uid))) primaries.emplace_back(uid, track);
  }
  for (const auto& [uid, track] : near_secondaries_) {
    const bool near = std::abs(track->behind) <= 1 && mark.running - track->taken >= tws::kHalfTurn;
    if (near && isFree(table_.ofSecondary(uid))) secondaries.emplace_back(uid, track);
  }
  std::vector<GatedPair> pairs;
  for (std::uint32_t p = 0; p < primaries.size(); ++p) {
    for (std::uint32_t s = 0; s < secondaries.size(); ++s) {
      const double d = distance(*primaries[p].second, *secondaries[s].second, mark.time);
      if (d <= params_.gate) pairs.push_back({p, s, d});
    }
  }
  for (const GatedPair& pair : association_.solve(pairs, primaries.size(), secondaries.size(), params_.gate)) {
    if (primaries[pair.primary].second->isDue(mark.running))
      commit(primaries[pair.primary].first, secondaries[pair.secondary].first, mark.running);
  }
  counts_.clusters += association_.clusters();
}

/// Position and velocity, each by its own errors: (a - b)ᵀ·(P_a + P_b + bias)⁻¹·(a - b).
double Correlator::distance(const KnownTrack& primary, const KnownTrack& secondary, double time) const {
  const Eigen::Vector4d apart = primary.at(time) - secondary.at(time);
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
  KnownTrack& p = primaries_.at(primary);
  KnownTrack& s = secondaries_.at(secondary);
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
  for (const auto& [uid, primary] : near_primaries_)
    if (primary->isDue(running)) dissolve(table_.ofPrimary(uid));
}

bool Correlator::holds(bool primary, std::uint32_t uid) const {
  const KnownTracks& tracks = primary ? primaries_ : secondaries_;
  const FusionRow* row = primary ? table_.ofPrimary(uid) : table_.ofSecondary(uid);
  return tracks.contains(uid) || row != nullptr || std::any_of(ended_.begin(), ended_.end(), [&](const auto& update) {
           return (primary ? update.primary : update.secondary) == uid;
         });
}

std::uint32_t Correlator::identityOf(KnownTrack& track) {
  if (track.identity == 0) track.identity = ++last_identity_;
  return track.identity;
}

void Correlator::report(const Mark& mark) {
  CorrelatorReport report{mark.running, mark.time, std::move(ended_)};
  ended_.clear();
  for (const auto& [uid, track] : near_primaries_) {
    if (!track->isDue(mark.running)) continue;
    track->done = mark.running;
    const FusionRow* row = table_.ofPrimary(uid);
    const std::uint32_t identity = identityOf(*track);
    if (row != nullptr && !row->secondary_lost) secondaries_.at(row->secondary).identity = identity;
    CorrelatedUpdate alone;
    alone.identity = identity;
    alone.primary = uid;
    report.updates.push_back(row == nullptr ? alone : updateOf(*row, identity));
  }
  for (const auto& [uid, track] : near_secondaries_) {
    if (!track->isDue(mark.running)) continue;
    track->done = mark.running;
    const FusionRow* row = table_.ofSecondary(uid);
    if (row != nullptr && !row->primary_lost) continue;  // The primary stands for both.
    CorrelatedUpdate alone;
    alone.identity = identityOf(*track);
    alone.secondary = uid;
    report.updates.push_back(row == nullptr ? alone : updateOf(*row, track->identity));
  }
  on_report_(report);
}

}  // namespace track_correlator
