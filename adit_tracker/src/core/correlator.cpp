#include "core/correlator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <tws_core/angles.h>
#include <tws_core/sectors.h>

namespace adit_tracker {
namespace {
constexpr double kManoeuvreSigmas = 3.0;  // half-width of the region of a hard manoeuvre, standard deviations
constexpr double kHardManoeuvre = 0.01;   // chance of one
// A tentative track, of which there may be many, does not ask for a detection that is so much likelier a false one.
constexpr double kHardlyOwn = 0.02;

tws::Symmetric2 widened(const tws::Symmetric2& covariance, double variance) {
  return {covariance.xx + variance, covariance.xy, covariance.yy + variance};
}

double density(const tws::Symmetric2& covariance, double squared_distance) {
  return std::exp(-0.5 * squared_distance) / (2.0 * tws::kPi * std::sqrt(covariance.determinant()));
}

RateMatch matchOf(const RatePrediction& rate, const RatePrediction::Expected& expected, const tws::Plot& plot,
                  const RadarQuality& quality) {
  const double off =
      quality.rangeRate(plot.range_rate).difference(plot.range_rate - expected.shift, static_cast<double>(rate.value));
  return {off * off / expected.variance, expected.variance};
}

/// None where the plot has no range rate, or the track cannot be asked about it.
std::optional<RateMatch> matchOf(const Track& track, const tws::Plot& plot, const RadarQuality& quality,
                                 double by_range, double across) {
  const RatePrediction& rate = track.predicted_rate;
  if (!rate.known() || !quality.rangeRate(plot.range_rate).known()) return std::nullopt;
  return matchOf(rate, rate.given(track.predicted.innovation, by_range, across), plot, quality);
}

/// The same in a hard manoeuvre; `wide`: the innovation's covariance with it.
RateMatch manoeuvreMatchOf(const Track& track, const tws::Symmetric2& wide, const tws::Plot& plot,
                           const RadarQuality& quality, double by_range, double across) {
  const RatePrediction& rate = track.predicted_rate;
  const double spread = std::sqrt(track.predicted.manoeuvre);
  return matchOf(rate, rate.givenManoeuvre(wide, spread, by_range, across), plot, quality);
}

/// Squared distance at which a tentative track leaves a detection alone where one false plot comes on a square metre;
/// less twice the logarithm of their density, where they are many. A range rate may speak for the detection.
double farthestOf(const Track& track, const RadarQuality& quality) {
  constexpr double kRounding = 1e-9;
  const auto rate_variance = static_cast<double>(track.predicted_rate.variance);
  const double by_rate = track.predicted_rate.known()
                             ? std::max(0.0, std::log(quality.rateSpan() * quality.rateSpan() /
                                                      (tws::kTwoPi * RatePrediction::kLeast * rate_variance)))
                             : 0.0;
  return kRounding + by_rate - 2.0 * std::log(2.0 * tws::kPi * kHardlyOwn) -
         std::log(track.predicted.innovation.determinant());
}

/// The track's claim to the detection, a new one if it has none.
PlotClaim& claimOf(Detection& detection, std::uint32_t uid) {
  auto& claims = detection.claims;
  const auto claim = std::find_if(claims.begin(), claims.end(), [&](const PlotClaim& c) { return c.uid == uid; });
  if (claim != claims.end()) return *claim;
  claims.push_back({uid, 0.0F});
  return claims.back();
}
}  // namespace

std::size_t Correlator::smallestGate(const Track& track, const tws::Plot& plot, const RadarQuality& quality,
                                     const std::optional<RateMatch>& rate, double range_difference,
                                     double azimuth_difference, double& distance) const {
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
  double squared = p.innovation.mahalanobis(range_difference, cross_range);
  distance = squared + p.log_volume;
  if (rate && squared <= greatest) {
    squared += rate->squared;
    const double own = quality.rangeRate(plot.range_rate).sigma;
    distance += rate->squared + std::log(rate->variance / (own * own));
  }
  if (squared > greatest) {
    if (manoeuvreOf(track) == 0.0) return kGates;
    // What only a hard manoeuvre explains comes last of all.
    const auto covariance = widened(p.innovation, p.manoeuvre);
    double wide = covariance.mahalanobis(range_difference, cross_range);
    if (rate) wide += manoeuvreMatchOf(track, covariance, plot, quality, range_difference, cross_range).squared;
    return wide <= kManoeuvreSigmas * kManoeuvreSigmas ? kGates - 1 : kGates;
  }
  std::size_t g = 0;
  while (g + 1 < kGates && distance > params_.gate_distances[g]) ++g;
  return g;
}

/// Variance that a hard manoeuvre adds. Where chances count, a tentative track makes none.
double Correlator::manoeuvreOf(const Track& track) const {
  return byChances() && !track.firm ? 0.0 : track.predicted.manoeuvre;
}

/// The half-widths of the largest region.
Correlator::Reach Correlator::reachOf(const Track& track) const {
  const Prediction& p = track.predicted;
  const double manoeuvre = manoeuvreOf(track);
  if (params_.gates == GateKind::kFixed) return {params_.track_gates.back().range, params_.track_gates.back().azimuth};
  const auto halfWidth = [&](double variance) {
    const double usual = params_.gate_sigmas * std::sqrt(variance);
    return manoeuvre == 0.0 ? usual : std::max(usual, kManoeuvreSigmas * std::sqrt(variance + manoeuvre));
  };
  return {halfWidth(p.innovation.xx), halfWidth(p.innovation.yy) / p.range};
}

void Correlator::Frontier::clear(DetectionFile& detections, std::int64_t sector) {
  azimuth_ = tws::sectorStart(static_cast<int>(sector % tws::kSectors));
  std::size_t count = 1;
  double greatest_range = 1.0;
  for (std::int64_t s = sector - 1; s <= sector + 1; ++s) {
    const auto& places = detections.at(s).places;
    count = std::max(count, places.size());
    if (!places.empty()) greatest_range = std::max(greatest_range, places.back().range);
  }
  bin_ = greatest_range / static_cast<double>(count);
  farthest_.assign(count, -std::numeric_limits<double>::infinity());
}

std::size_t Correlator::Frontier::binOf(double range) const {
  return static_cast<std::size_t>(std::clamp(range / bin_, 0.0, static_cast<double>(farthest_.size() - 1)));
}

void Correlator::Frontier::add(double range, double azimuth) {
  azimuth = tws::angularDifference(azimuth, azimuth_);
  double& farthest = farthest_[binOf(range)];
  // What is behind the site or beside it counts as far off: there, "further clockwise" has no meaning.
  farthest = std::max(farthest, std::abs(azimuth) < 0.5 * tws::kPi ? azimuth : tws::kTwoPi);
}

bool Correlator::Frontier::meets(const Prediction& middle, const Reach& reach) const {
  if (reach.azimuth > 0.5 * tws::kPi) return true;
  constexpr double kRounding = 1e-6;  // [rad], [m]
  const double nearest = tws::angularDifference(middle.azimuth, azimuth_) - reach.azimuth - kRounding;
  const std::size_t last = binOf(middle.range + reach.range + kRounding);
  for (std::size_t bin = binOf(middle.range - reach.range - kRounding); bin <= last; ++bin) {
    if (farthest_[bin] >= nearest) return true;
  }
  return false;
}

/// What is noted with a detection in this run.
void Correlator::beginNotes(Detection& detection, const FalsePlotMap& map) const {
  detection.asked_in = run_;
  detection.askers = 0;
  detection.index = Detection::kNoIndex;
  detection.false_density = map.density(detection.plot.range, detection.plot.azimuth);
  detection.crowding = map.areMany(detection.false_density) ? 2.0 * std::log(detection.false_density)
                                                            : -std::numeric_limits<double>::infinity();
}

/// Fills in the likelihood. False: a tentative track leaves such a detection alone; where they are many, the comparison
/// with `farthest` says so of nearly all before anything is worked out.
bool Correlator::mayBeOf(const Track& track, Candidate& candidate, const std::optional<RateMatch>& rate,
                         double range_difference, double azimuth_difference, double farthest,
                         const RadarQuality& quality) const {
  const FalsePlotMap& map = quality.falsePlotMap();
  const Prediction& p = track.predicted;
  Detection& detection = *candidate.detection;
  if (detection.asked_in != run_) beginNotes(detection, map);
  const double across = p.range * azimuth_difference;
  const double squared = p.innovation.mahalanobis(range_difference, across);
  if (!track.firm && squared > farthest - detection.crowding) return false;
  const double manoeuvre = manoeuvreOf(track);
  candidate.likelihood = density(p.innovation, squared);
  if (rate) candidate.likelihood *= rate->likelihood(quality.rateSpan());
  if (manoeuvre > 0.0) {
    const auto wide = widened(p.innovation, manoeuvre);
    double hard = kHardManoeuvre * density(wide, wide.mahalanobis(range_difference, across));
    if (rate) {
      hard *= manoeuvreMatchOf(track, wide, detection.plot, quality, range_difference, across)
                  .likelihood(quality.rateSpan());
    }
    candidate.likelihood += hard;
  }
  if (track.firm) return true;
  const double own = track.counted_false[p.radar];
  if (own > 0.0)
    candidate.likelihood *= detection.false_density / map.densityAround(own, detection.false_density,
                                                                        detection.plot.range, detection.plot.azimuth);
  return detection.left * candidate.likelihood > kHardlyOwn * detection.false_density;
}

void Correlator::gather(const Track& track, const Asker& asker, RadarState& radar) {
  const Prediction& p = track.predicted;
  const double farthest = byChances() && !track.firm ? farthestOf(track, radar.quality) : 0.0;
  Entry entry{asker.slot, asker.order, asker.primary, false, candidates_.size(), 0};
  const auto consider = [&](Detection& detection, double range_difference, double azimuth_difference) {
    double distance = 0.0;
    const auto rate = matchOf(track, detection.plot, radar.quality, range_difference, p.range * azimuth_difference);
    std::size_t gate =
        smallestGate(track, detection.plot, radar.quality, rate, range_difference, azimuth_difference, distance);
    if (gate == kGates) return;
    // A branch takes what all others leave: else it would live on its parent's detections.
    if (track.parent != 0 && !track.firm) gate = kGates - 1;
    Candidate candidate{&detection, distance, gate};
    if (byChances() && !mayBeOf(track, candidate, rate, range_difference, azimuth_difference, farthest, radar.quality))
      return;
    candidates_.push_back(candidate);
    frontier_.add(p.range + range_difference, p.azimuth + azimuth_difference);
  };
  for (std::int64_t s = asker.sector - 1; s <= asker.sector + 1; ++s) {
    radar.detections.at(s).near(p.range, p.azimuth, asker.reach.range, asker.reach.azimuth, consider);
  }
  entry.last = candidates_.size();
  if (entry.last > entry.first) entries_.push_back(entry);
}

void Correlator::gatherPrimary(const TrackFile& tracks, const std::vector<TrackFile::Slot>& slots, RadarState& radar,
                               std::int64_t running) {
  std::size_t order = 0;
  for (const auto slot : slots) {
    const Track& track = tracks.at(slot);
    gather(track, {slot, order++, true, running, reachOf(track), true}, radar);
  }
}

/// Only those secondary tracks matter that may want a candidate of a primary one, or of another one that matters.
void Correlator::gatherSecondary(const TrackFile& tracks, const std::vector<TrackFile::Slot>& slots, RadarState& radar,
                                 std::int64_t running, std::size_t site) {
  const int here = static_cast<int>(running % tws::kSectors);
  secondary_.clear();
  for (const auto slot : slots) {
    const std::int64_t sector = running + tws::sectorDifference(tracks.sector(slot, site), here);
    secondary_.push_back({slot, secondary_.size(), false, sector, reachOf(tracks.at(slot)), false});
  }
  const std::size_t primary = entries_.size();
  for (bool grown = true; grown;) {
    grown = false;
    for (Asker& asker : secondary_) {
      const Track& track = tracks.at(asker.slot);
      if (asker.asked || !frontier_.meets(track.predicted, asker.reach)) continue;
      asker.asked = grown = true;
      gather(track, asker, radar);
    }
  }
  std::sort(entries_.begin() + static_cast<std::ptrdiff_t>(primary), entries_.end(),
            [](const Entry& a, const Entry& b) { return a.order < b.order; });
}

ClusterWeigher::Resolution Correlator::resolutionOf(const RadarQuality& quality) const {
  return {params_.parting.cell_range_sigmas * quality.rangeSigma(),
          params_.parting.cell_azimuth_sigmas * quality.azimuthSigma(), params_.bifurcation ? quality.merging() : 0.0};
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
    detection->taker = entry.slot;
    detection->promised = !entry.primary;
    if (entry.primary) {
      detection->use();
      correlations_.push_back({entry.slot, detection});
    } else {
      detection->flagged_in = run_;
    }
  }
}

void Correlator::noteClaims(const TrackFile& tracks) const {
  for (const Entry& entry : entries_) {
    const Track& track = tracks.at(entry.slot);
    for (std::size_t i = entry.first; i < entry.last; ++i) {
      const Candidate& c = candidates_[i];
      const double squared = std::max(0.0, c.distance - track.predicted.log_volume);
      claimOf(*c.detection, track.uid).sigmas = params_.gates == GateKind::kFixed
                                                    ? std::numeric_limits<float>::quiet_NaN()
                                                    : static_cast<float>(std::sqrt(squared));
    }
  }
  for (const Correlation& c : correlations_) {
    const std::uint32_t uid = tracks.at(c.slot).uid;
    for (std::size_t i = c.first; i < c.last; ++i) {
      const PlotChance& plot = chances()[i];
      claimOf(*plot.detection, uid).chance = static_cast<float>(plot.chance * c.unhidden);
    }
    if (c.detection == nullptr) continue;
    PlotClaim& claim = claimOf(*c.detection, uid);
    claim.took = true;
    if (!c.weighed) claim.chance = static_cast<float>(1.0 - c.detection->left);
  }
}

const std::vector<Correlation>& Correlator::correlate(const TrackFile& tracks,
                                                      const std::vector<TrackFile::Slot>& primary,
                                                      const std::vector<TrackFile::Slot>& secondary, RadarState& radar,
                                                      std::int64_t running, std::size_t site) {
  ++run_;
  entries_.clear();
  candidates_.clear();
  correlations_.clear();
  frontier_.clear(radar.detections, running);
  gatherPrimary(tracks, primary, radar, running);
  if (candidates_.empty()) return correlations_;
  gatherSecondary(tracks, secondary, radar, running, site);
  if (byChances()) {
    weigher_.weigh(tracks, entries_, candidates_, resolutionOf(radar.quality), run_, correlations_);
  } else {
    for (std::size_t gate = 0; gate < kGates; ++gate) pass(gate);
  }
  if (keeps_claims_) noteClaims(tracks);
  return correlations_;
}

}  // namespace adit_tracker
