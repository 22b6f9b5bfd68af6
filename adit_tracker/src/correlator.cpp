#include "correlator.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace adit_tracker {
namespace {
// Squared limit, in standard deviations of a hard manoeuvre: three of them.
constexpr double kManoeuvreGate = 9.0;
}  // namespace

std::size_t Correlator::smallestGate(const Track& track, double range_difference, double azimuth_difference,
                                     double& distance) const {
  if (params_.gates == GateKind::kFixed) {
    for (std::size_t g = 0; g < kGates; ++g) {
      const Gate& gate = params_.track_gates[g];
      if (std::abs(range_difference) > gate.range || std::abs(azimuth_difference) > gate.azimuth) continue;
      distance = effectiveDistance(gate, range_difference, azimuth_difference);
      return g;
    }
    return kGates;
  }
  // The distance is twice the negative log-likelihood, up to a constant: of two tracks, the one that knows better where
  // its target is wins.
  const Prediction& p = track.predicted;
  const double cross_range = p.range * azimuth_difference;
  const double greatest = params_.gate_sigmas * params_.gate_sigmas;
  const double squared = p.innovation.mahalanobis(range_difference, cross_range);
  distance = squared + p.log_volume;
  if (squared > greatest) {
    // What only a hard manoeuvre explains comes last of all.
    const Symmetric2 wide{p.innovation.xx + p.manoeuvre, p.innovation.xy, p.innovation.yy + p.manoeuvre};
    return wide.mahalanobis(range_difference, cross_range) <= kManoeuvreGate ? kGates - 1 : kGates;
  }
  std::size_t g = 0;
  while (g + 1 < kGates && distance > params_.gate_distances[g]) ++g;
  return g;
}

/// The half-widths of the largest region.
Correlator::Reach Correlator::reachOf(const Prediction& p) const {
  if (params_.gates == GateKind::kFixed) return {params_.track_gates.back().range, params_.track_gates.back().azimuth};
  return {params_.gate_sigmas * std::sqrt(p.innovation.xx + p.manoeuvre),
          params_.gate_sigmas * std::sqrt(p.innovation.yy + p.manoeuvre) / p.range};
}

void Correlator::gather(const Track& track, TrackFile::Slot slot, bool primary, RadarState& radar,
                        std::int64_t sector) {
  const Prediction& p = track.predicted;
  const Reach reach = reachOf(p);
  Entry entry{slot, primary, false, candidates_.size(), 0};
  const auto consider = [&](Detection& detection, double range_difference, double azimuth_difference) {
    double distance = 0.0;
    const std::size_t gate = smallestGate(track, range_difference, azimuth_difference, distance);
    if (gate < kGates) candidates_.push_back({&detection, distance, gate});
  };
  for (std::int64_t s = sector - 1; s <= sector + 1; ++s) {
    radar.detections.at(s).near(p.range, p.azimuth, reach.range, reach.azimuth, consider);
  }
  entry.last = candidates_.size();
  if (entry.last > entry.first) entries_.push_back(entry);
}

Detection* Correlator::closest(const Entry& entry, std::size_t gate) const {
  const Candidate* best = nullptr;
  for (std::size_t i = entry.first; i < entry.last; ++i) {
    const Candidate& c = candidates_[i];
    if (c.gate > gate || c.detection->used || c.detection->flagged_in == run_) continue;
    if (best == nullptr || c.distance < best->distance) best = &c;
  }
  return best == nullptr ? nullptr : best->detection;
}

void Correlator::pass(std::size_t gate) {
  for (Entry& entry : entries_) {
    if (entry.correlated) continue;
    Detection* const detection = closest(entry, gate);
    if (detection == nullptr) continue;
    entry.correlated = true;
    if (entry.primary) {
      detection->used = true;
      correlations_.push_back({entry.slot, detection});
    } else {
      detection->flagged_in = run_;
    }
  }
}

const std::vector<Correlation>& Correlator::correlate(const TrackFile& tracks,
                                                      const std::vector<TrackFile::Slot>& primary,
                                                      const std::vector<TrackFile::Slot>& secondary, RadarState& radar,
                                                      std::int64_t running) {
  ++run_;
  entries_.clear();
  candidates_.clear();
  correlations_.clear();
  for (const auto slot : primary) gather(tracks.at(slot), slot, true, radar, running);
  if (candidates_.empty()) return correlations_;
  const int here = static_cast<int>(running % tws::kSectors);
  for (const auto slot : secondary) {
    gather(tracks.at(slot), slot, false, radar, running + tws::sectorDifference(tracks.sector(slot), here));
  }
  for (std::size_t gate = 0; gate < kGates; ++gate) pass(gate);
  return correlations_;
}

}  // namespace adit_tracker
