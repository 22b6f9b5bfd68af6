#include "frame_view.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace esa_frame_builder {
namespace {

const double kLog2 = std::log(2.0);

}  // namespace

double beamLoss(const Dwell& dwell, const ArrayView& view) {
  // Two ways, the power falls to a quarter at the half-power width: exp(-8·ln2·(offset/Θ)²), a Gaussian of variance
  // Θ²/(16·ln2), here convolved with that of the direction.
  Eigen::Matrix2d beam = Eigen::Matrix2d::Zero();
  beam.diagonal() << dwell.beamwidth_u * dwell.beamwidth_u, dwell.beamwidth_v * dwell.beamwidth_v;
  beam /= 16.0 * kLog2;
  const Eigen::Matrix2d widened = beam + view.covariance;
  const Eigen::Vector2d offset(view.u - dwell.u, view.v - dwell.v);
  return std::sqrt(beam.determinant() / widened.determinant()) *
         std::exp(-0.5 * offset.dot(widened.inverse() * offset));
}

double detectionProbability(double snr, double false_alarm_probability) {
  return std::pow(false_alarm_probability, 1.0 / (1.0 + snr));
}

FrameView viewOf(const FrameTrack& track, const Frame& frame, const ArrayPose& pose, const MfaStubParams& params) {
  FrameView view;
  double missed = 1.0, best = 0.0;
  for (const Dwell& dwell : frame.dwells) {
    if (dwell.time < track.time) continue;
    tws::SpatialState state = track.state;
    tws::predict(state, dwell.time - track.time, params.acceleration_density);
    const ArrayView seen = arrayView(state, pose);
    if (!seen.is_ahead || seen.range < dwell.range_min || seen.range > dwell.range_max) continue;
    const double chance = detectionProbability(track.snr * beamLoss(dwell, seen), params.false_alarm_probability);
    missed *= 1.0 - chance;
    if (chance <= best) continue;
    best = chance;
    view.time = dwell.time;
  }
  view.detection_probability = 1.0 - missed;
  return view;
}

}  // namespace esa_frame_builder
