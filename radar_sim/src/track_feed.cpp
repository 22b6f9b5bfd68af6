#include "track_feed.h"

#include <random>

#include <tws_core/geometry.h>
#include <tws_core/sectors.h>

#include "random_stream.h"

namespace radar_sim {

TrackFeed::TrackFeed(FeedKind kind, TrackFeedParams params, const Eigen::Isometry3d& map_to_radar,
                     const std::vector<Target>& targets, std::uint64_t seed)
    : kind_(kind),
      params_(std::move(params)),
      map_to_radar_(map_to_radar),
      targets_(targets),
      seed_(seed),
      lives_(targets.size()) {}

std::vector<FedTrack> TrackFeed::tracksOf(const tws::RadarSector& sector) {
  std::vector<FedTrack> updates;
  for (std::size_t target = 0; target < targets_.size(); ++target) {
    Life& life = lives_[target];
    if (!existsAt(targets_[target], sector.enter_time)) {
      life.update.dropped = true;
      if (life.alive) updates.push_back(life.update);
      life.alive = false;
      continue;
    }
    const TargetState truth = targets_[target].trajectory->at(sector.enter_time);
    Eigen::Vector4d state = stateOf(truth);
    // Once a scan; also what has moved against the beam, out of a sector that was still to come.
    const int behind = tws::sectorDifference(sector.sector, tws::sectorOf(tws::azimuthOf(state.head<2>())));
    if (behind < 0 || behind > 2 || sector.running - life.updated < tws::kHalfTurn) continue;
    addErrors(targets_[target], sector.running / tws::kSectors, state);
    if (!life.alive) life.update = FedTrack{target, ++last_number_, false, sector.enter_time, sector.enter_time};
    life.update.time = sector.enter_time;
    life.update.state = state;
    life.update.height = kind_ == FeedKind::kSecondary ? truth.height : std::numeric_limits<double>::quiet_NaN();
    life.alive = true;
    life.updated = sector.running;
    updates.push_back(life.update);
  }
  return updates;
}

bool TrackFeed::existsAt(const Target& target, double time) const {
  if (target.kind == TargetKind::kClutter || !target.trajectory->existsAt(time)) return false;
  if (kind_ == FeedKind::kPrimary) return true;
  const Transponder& transponder = target.transponder;
  const bool replies = transponder.altitude || transponder.codes != Transponder().codes;
  return replies && !transponder.isSilentAt(time);
}

Eigen::Vector4d TrackFeed::stateOf(const TargetState& truth) const {
  const Eigen::Vector3d place = map_to_radar_ * truth.position;
  const tws::Polar polar = tws::polarFromEnu(place);
  const tws::PolarRates rates = tws::polarRates(place, map_to_radar_.linear() * truth.velocity);
  Eigen::Vector4d state;
  state << tws::planarFromPolar(polar.range, polar.azimuth),
      tws::planarVelocity(polar.range, polar.azimuth, rates.range, rates.azimuth);
  return state;
}

void TrackFeed::addErrors(const Target& target, std::int64_t scan, Eigen::Vector4d& state) const {
  const std::string feed = kind_ == FeedKind::kPrimary ? "primary track of " : "secondary track of ";
  RandomStream stream(seed_, feed + target.name, static_cast<std::uint64_t>(scan));
  std::normal_distribution<double> error;
  for (int i = 0; i < 4; ++i) state(i) += error(stream) * (i < 2 ? params_.position_sigma : params_.velocity_sigma);
}

}  // namespace radar_sim
