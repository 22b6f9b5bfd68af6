#include "epoch.h"

namespace track_evaluation {

PlanarState onSlantPlane(const Eigen::Vector3d& position, const Eigen::Vector3d& velocity,
                         const Eigen::Vector3d& site) {
  const Eigen::Vector3d line = position - site;
  const double slant = line.norm(), ground = line.head<2>().norm();
  if (ground <= 0.0) return {site.head<2>(), velocity.head<2>()};
  const Eigen::Vector2d outwards = line.head<2>() / ground, along(-outwards.y(), outwards.x());
  const double range_rate = line.dot(velocity) / slant;
  const double turn_rate = along.dot(velocity.head<2>()) / ground;
  return {site.head<2>() + slant * outwards, range_rate * outwards + slant * turn_rate * along};
}

void Distances::compute(const Epoch& epoch) {
  tracks_ = epoch.tracks.size();
  values_.resize(epoch.truths.size() * tracks_);
  double* value = values_.data();
  for (const TruthState& truth : epoch.truths) {
    for (const TrackState& track : epoch.tracks)
      *value++ = (comparable(truth, track).position - track.state.position).norm();
  }
}

}  // namespace track_evaluation
