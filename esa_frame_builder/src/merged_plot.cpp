#include "merged_plot.h"

#include <cmath>

namespace esa_frame_builder {
namespace {

constexpr double kLeastLoss = 0.05;  // further out in the beam a target adds next to nothing

bool canMerge(const FrameTrack& track, const DwellView& view) {
  return track.stage == TrackStage::kFirm && view.loss >= kLeastLoss;
}

}  // namespace

MergedPlot mergedPlot(std::size_t track, std::size_t dwell, const std::vector<const FrameTrack*>& tracks,
                      const std::vector<FrameView>& views, double range_resolution) {
  MergedPlot merged{{}, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero()};
  const DwellView& own = views[track].dwells[dwell];
  if (!canMerge(*tracks[track], own)) return merged;
  double power = 0.0;
  const auto share = [&](std::size_t i) { return tracks[i]->snr * views[i].dwells[dwell].loss; };
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    const DwellView& view = views[i].dwells[dwell];
    if (!canMerge(*tracks[i], view) || std::abs(view.seen.range - own.seen.range) > range_resolution) continue;
    merged.members.push_back(i);
    merged.place += share(i) * view.state.mean.head<3>();
    power += share(i);
  }
  if (merged.members.size() < 2) return MergedPlot{{}, merged.place, merged.covariance};
  merged.place /= power;
  for (const std::size_t i : merged.members) {
    const tws::SpatialState& state = views[i].dwells[dwell].state;
    const double part = share(i) / power;
    const Eigen::Vector3d off = state.mean.head<3>() - merged.place;
    // Of two equal targets that fluctuate (Swerling 1) the part of each is uniform: a variance of 1/12 of the distance
    // squared, which is a third of this.
    merged.covariance += part * part * state.covariance.topLeftCorner<3, 3>() + part / 3.0 * off * off.transpose();
  }
  return merged;
}

tws::SpatialMeasurement memberMeasurement(const MergedPlot& merged, const tws::SpatialMeasurement& measured,
                                          const tws::SpatialState& member) {
  return {member.mean.head<3>() + measured.position - merged.place, measured.covariance + merged.covariance};
}

}  // namespace esa_frame_builder
