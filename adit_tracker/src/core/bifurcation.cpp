#include "core/bifurcation.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>

namespace adit_tracker {
namespace {

constexpr std::int64_t kSectorsKept = 3;   // a detection may be shared by tracks of this and the two sectors before
constexpr double kMarginSigmas = 1.5;      // how far two unresolved tracks may seem to lie outside of one cell
constexpr double kGreatestMiss = 4.0;      // how far the merged plot may lie from their middle, standard deviations
constexpr double kSurelyBoth = 0.8;        // least chance that a plot is of both
constexpr double kLeastUnresolved = 20.0;  // of a track that has not settled [s]
constexpr double kLeastSpeedSigma = 25.0;  // of a branch [m/s]

/// Where a track is expected as seen from a plot, along the beam and across it [m]. The covariance holds the errors of
/// both.
struct Expected {
  double along, across;
  tws::Symmetric2 covariance;
};

/// Is the track still aimed at the beam that made the plot? Not when it was met in the sector before.
bool isAimed(const Prediction& p, const tws::Plot& plot, std::size_t radar) {
  constexpr double kTolerance = 0.3;  // [s]
  return p.radar == radar && std::abs(p.time - plot.time) < kTolerance;
}

Expected expectedFrom(const tws::Plot& plot, const Prediction& p, const RadarQuality& quality) {
  const double along = quality.rangeSigma(), across = plot.range * quality.azimuthSigma();
  const bool known = p.innovation.xx > 0.0;  // the α-β filter has no covariance
  return {p.range - plot.range, plot.range * tws::angularDifference(p.azimuth, plot.azimuth),
          known ? p.innovation : tws::Symmetric2{2.0 * along * along, 0.0, 2.0 * across * across}};
}

Expected expectedFrom(const tws::Plot& plot, const Track& track, const TrackMotion& motion, std::size_t radar,
                      const RadarQuality& quality) {
  if (isAimed(track.predicted, plot, radar)) return expectedFrom(plot, track.predicted, quality);
  Track copy = track;
  motion.predict(copy, radar, plot.time, quality);
  return expectedFrom(plot, copy.predicted, quality);
}

/// Density of a normal distribution at a distance from its middle, up to a constant.
double density(const tws::Symmetric2& covariance, double along, double across) {
  return std::exp(-0.5 * covariance.mahalanobis(along, across)) / std::sqrt(covariance.determinant());
}

/// The plot moved [m] towards one of the targets that it stands for, with `spread` times the distance of both as
/// further standard deviation. Whose range rate it has, nobody knows.
tws::Plot towards(double along, double across, double distance_along, double distance_across, double spread,
                  tws::Plot plot, const RadarQuality& quality) {
  plot.range_sigma = std::hypot(quality.rangeSigma(plot), spread * distance_along);
  plot.azimuth_sigma = std::hypot(quality.azimuthSigma(plot), spread * distance_across / plot.range);
  plot.azimuth = tws::wrapTwoPi(plot.azimuth + across / plot.range);
  plot.range = std::max(plot.range + along, 1.0);
  plot.range_rate = tws::Plot::kUnknown;
  return plot;
}

/// Seconds since the parent was last seen before its latest detection, by any radar.
double unseen(const Track& parent, std::size_t radar, double period) {
  double least = period;
  for (std::size_t other = 0; other < parent.updated.size(); ++other) {
    const double elapsed = parent.updated[radar] - parent.updated[other];
    if (other != radar && elapsed > 0.5) least = std::min(least, elapsed);
  }
  return least;
}

}  // namespace

Bifurcation::Bifurcation(const AditParams& params) : params_(params), greatest_speed_(params.parting.speed) {
  for (const Volume& volume : params.volumes) greatest_speed_ = std::max(greatest_speed_, volume.params.parting.speed);
}

Bifurcation::Reach Bifurcation::cellOf(const RadarQuality& quality) const {
  return {params_.parting.cell_range_sigmas * quality.rangeSigma(),
          params_.parting.cell_azimuth_sigmas * quality.azimuthSigma()};
}

/// Surely in one cell, if tracks as firm as these two are anywhere.
bool Bifurcation::areWithinHalf(const Reach& cell, const Track& a, const Track& b) {
  const Prediction &p = a.predicted, &q = b.predicted;
  return a.firm && b.firm && std::abs(p.range - q.range) < 0.5 * cell.range &&
         std::abs(tws::angularDifference(p.azimuth, q.azimuth)) < 0.5 * cell.azimuth;
}

/// Two tracks in one cell that have each got a detection: this radar tells them apart.
void Bifurcation::learnResolution(const Run& run, const std::vector<Correlation>& pairs) const {
  const Reach cell = cellOf(run.radar.quality);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (!pairs[i].weighed || pairs[i].detection == nullptr) continue;
    for (std::size_t j = i + 1; j < pairs.size() && pairs[j].weighed && pairs[j].cluster == pairs[i].cluster; ++j) {
      const bool both = pairs[j].detection != nullptr && pairs[j].detection != pairs[i].detection;
      if (both && areWithinHalf(cell, run.tracks.at(pairs[i].slot), run.tracks.at(pairs[j].slot)))
        run.radar.quality.learnMerging(0.0);
    }
  }
}

/// Does the radar see both as one, and is the plot rather of both than of the taker alone? Where the powers
/// of both fluctuate alike, the merged plot lies anywhere on the line between them with equal chance.
std::optional<Bifurcation::Shared> Bifurcation::shareOf(const Run& run, const Track& hidden, const Track& taker,
                                                        const Detection& detection) const {
  const tws::Plot& plot = detection.plot;
  const RadarQuality& quality = run.radar.quality;
  const Expected a = expectedFrom(plot, hidden, run.motion, run.sector.radar, quality);
  const Expected b = expectedFrom(plot, taker, run.motion, run.sector.radar, quality);
  const tws::Symmetric2 error{std::pow(quality.rangeSigma(), 2), 0.0, std::pow(plot.range * quality.azimuthSigma(), 2)};
  const tws::Symmetric2 both{a.covariance.xx + b.covariance.xx, a.covariance.xy + b.covariance.xy,
                             a.covariance.yy + b.covariance.yy};
  // Outside of one cell by their own errors and by manoeuvres only; then, they are at its ends.
  const auto inOneCell = [&](double& distance, double variance, double cell) {
    const bool fits = std::abs(distance) <= cell + kMarginSigmas * std::sqrt(variance + hidden.predicted.manoeuvre);
    distance = std::clamp(distance, -cell, cell);
    return fits;
  };
  const Reach cell = cellOf(quality);
  double along = a.along - b.along, across = a.across - b.across;  // from the taker to the hidden one
  if (!inOneCell(along, std::max(0.0, both.xx - 2.0 * error.xx), cell.range)) return std::nullopt;
  if (!inOneCell(across, std::max(0.0, both.yy - 2.0 * error.yy), cell.azimuth * plot.range)) return std::nullopt;

  const tws::Symmetric2 merged{0.25 * both.xx + 0.5 * error.xx + along * along / 12.0,
                               0.25 * both.xy + along * across / 12.0,
                               0.25 * both.yy + 0.5 * error.yy + across * across / 12.0};
  const double middle_along = b.along + 0.5 * along, middle_across = b.across + 0.5 * across;
  if (merged.mahalanobis(middle_along, middle_across) > kGreatestMiss * kGreatestMiss) return std::nullopt;
  const double there = hidden.detectionChance() * hidden.existence;
  const double as_both = there * quality.merging() * density(merged, middle_along, middle_across);
  const double as_taker = (1.0 - there) * density(b.covariance, b.along, b.across);
  const double chance = as_both / (as_both + as_taker);
  if (areWithinHalf(cell, hidden, taker)) run.radar.quality.learnMerging(chance);
  if (chance < kSurelyBoth) return std::nullopt;
  // The hidden one is half the distance further on; of the taker, that is so by that chance only.
  const double spread = std::sqrt(1.0 / 12.0), half = 0.5 * chance;
  const double taker_spread = std::sqrt(chance / 12.0 + 0.25 * chance * (1.0 - chance));
  return Shared{&detection,
                run.sector.running,
                &run.radar,
                0,
                hidden.uid,
                taker.uid,
                towards(0.5 * along, 0.5 * across, along, across, spread, plot, quality),
                towards(-half * along, -half * across, along, across, taker_spread, plot, quality)};
}

void Bifurcation::tryToShare(const Run& run, TrackFile::Slot slot) {
  const auto takesPart = [](const Track& track) { return track.firm || track.parent != 0; };
  const Track& track = run.tracks.at(slot);
  if (!takesPart(track)) return;
  const Prediction& p = track.predicted;
  const Reach cell = cellOf(run.radar.quality);
  std::optional<Shared> best;
  double least = 0.0;
  const auto consider = [&](const Detection& detection, double by_range, double by_azimuth) {
    if (!run.correlator.isTaken(detection) || detection.taker == slot) return;
    const Track& taker = run.tracks.at(detection.taker);
    const double distance = std::hypot(by_range, p.range * by_azimuth);
    if (!takesPart(taker) || (best && distance >= least)) return;
    auto shared = shareOf(run, track, taker, detection);
    if (!shared) return;
    best = shared;
    least = distance;
  };
  for (std::int64_t s = run.sector.running - 1; s <= run.sector.running + 1; ++s) {
    run.radar.detections.at(s).within(p.range, p.azimuth, 2.0 * cell.range, 1.5 * cell.azimuth, consider);
  }
  if (!best) return;
  best->slot = slot;
  shared_.push_back(*best);
}

void Bifurcation::share(const TrackFile& tracks, const TrackMotion& motion, const Correlator& correlator,
                        const std::vector<Correlation>& pairs, const std::vector<TrackFile::Slot>& primary,
                        RadarState& radar, const tws::SectorRef& sector) {
  const auto isOld = [&](const Shared& s) { return s.radar == &radar && s.running + kSectorsKept <= sector.running; };
  shared_.erase(std::remove_if(shared_.begin(), shared_.end(), isOld), shared_.end());
  now_ = shared_.size();
  correlated_.clear();
  for (const Correlation& pair : pairs) {
    if (pair.detection != nullptr) correlated_.push_back(pair.slot);
  }
  std::sort(correlated_.begin(), correlated_.end());
  const Run run{tracks, motion, correlator, radar, sector};
  learnResolution(run, pairs);
  for (const auto slot : primary) {
    if (!std::binary_search(correlated_.begin(), correlated_.end(), slot)) tryToShare(run, slot);
  }
  correlator.forEachSecondaryLeftOut([&](TrackFile::Slot slot) { tryToShare(run, slot); });
}

const Detection* Bifurcation::mergedPlotOf(TrackFile::Slot slot) const {
  for (std::size_t i = now_; i < shared_.size(); ++i) {
    if (shared_[i].slot == slot) return shared_[i].detection;
  }
  return nullptr;
}

const tws::Plot* Bifurcation::asSeenBy(const Track& track, const Detection& detection) const {
  for (auto s = shared_.rbegin(); s != shared_.rend(); ++s) {
    if (s->detection != &detection) continue;
    if (s->uid == track.uid) return &s->for_hidden;
    if (s->taker == track.uid) return &s->for_taker;
  }
  return nullptr;
}

bool Bifurcation::isShared(const Detection& detection) const {
  return std::any_of(shared_.begin(), shared_.end(), [&](const Shared& s) { return s.detection == &detection; });
}

bool Bifurcation::hasMerged(const Track& track, const Detection& detection) const {
  const double hidden = detection.plot.time - track.apart;
  const PartingParams& limits = partingIn(track);
  if (!track.firm) return hidden > limits.branch_time;
  const double limit = track.updates > kSettledUpdates ? limits.unresolved_time : kLeastUnresolved;
  const auto isYounger = [&](const Shared& s) {
    return s.detection == &detection && s.uid == track.uid && s.taker < track.uid;
  };
  return hidden > limit && std::any_of(shared_.begin(), shared_.end(), isYounger);
}

/// The targets were in one cell on the scan before, at the latest.
Bifurcation::Reach Bifurcation::partingReach(const tws::Plot& plot, const RadarState& radar, double speed) const {
  const Reach cell = cellOf(radar.quality);
  const double separation = speed * radar.antenna.period();
  return {cell.range + separation, cell.azimuth + separation / plot.range};
}

std::optional<Parting> Bifurcation::partingOf(const TrackFile& tracks, const Detection& detection, RadarState& radar,
                                              const tws::SectorRef& sector) const {
  if (detection.claim != Detection::kNoClaim) return std::nullopt;
  const tws::Plot& plot = detection.plot;
  const Reach reach = partingReach(plot, radar, greatest_speed_);
  std::optional<Parting> nearest;
  const auto consider = [&](const Detection& other, double by_range, double by_azimuth) {
    if (!other.isGiven() || isShared(other)) return;
    const Track& track = tracks.at(other.taker);
    if (!track.firm || track.updated[sector.radar] != other.plot.time) return;
    if (!params_.volumes.empty()) {
      const Reach own = partingReach(plot, radar, partingIn(track).speed);
      if (std::abs(by_range) > own.range || std::abs(by_azimuth) > own.azimuth) return;
    }
    const double along = -by_range, across = -plot.range * by_azimuth;
    if (nearest && std::hypot(along, across) >= std::hypot(nearest->along, nearest->across)) return;
    nearest = Parting{other.taker, plot.azimuth, along, across, 0.0, 0.0, 0.0, 0.0, 0.0};
  };
  for (std::int64_t s = sector.running - 2; s <= sector.running; ++s) {
    radar.detections.at(s).within(plot.range, plot.azimuth, reach.range, reach.azimuth, consider);
  }
  if (nearest) weigh(*nearest, tracks.at(nearest->parent), plot, radar, sector.radar);
  return nearest;
}

/// Up to the last time that they were seen as one, they were within one cell.
void Bifurcation::weigh(Parting& parting, const Track& parent, const tws::Plot& plot, const RadarState& radar,
                        std::size_t radar_index) const {
  const PartingParams& limits = partingIn(parent);
  const Reach cell = cellOf(radar.quality), reach = partingReach(plot, radar, limits.speed);
  const double usual = limits.speed_sigma, period = radar.antenna.period();
  const auto guess = [&](double distance, double width, double error, double elapsed, double& rate, double& sigma) {
    rate = 0.0;
    sigma = usual;
    if (std::abs(distance) <= width) return;
    rate = std::copysign(std::min((std::abs(distance) - 0.5 * width) / elapsed, limits.speed), distance);
    sigma = std::min(usual, kLeastSpeedSigma + std::sqrt(width * width / 12.0 + 2.0 * error * error) / elapsed);
  };
  guess(parting.along, cell.range, radar.quality.rangeSigma(), unseen(parent, radar_index, period), parting.rate_along,
        parting.sigma_along);
  guess(parting.across, cell.azimuth * plot.range, plot.range * radar.quality.azimuthSigma(), period,
        parting.rate_across, parting.sigma_across);
  const double false_plots =
      4.0 * reach.range * plot.range * reach.azimuth * radar.quality.falsePlotMap().density(plot.range, plot.azimuth);
  parting.chance = limits.per_scan / (limits.per_scan + false_plots);
}

}  // namespace adit_tracker
