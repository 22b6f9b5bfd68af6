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

DwellView viewOf(const FrameTrack& track, const Dwell& dwell, const ArrayPose& pose, const MfaStubParams& params) {
  DwellView view;
  if (dwell.time < track.time) return view;
  view.state = track.state;
  tws::predict(view.state, dwell.time - track.time, params.acceleration_density);
  view.seen = arrayView(view.state, pose);
  if (!view.seen.is_ahead || view.seen.range < dwell.range_min || view.seen.range > dwell.range_max) return view;
  view.loss = beamLoss(dwell, view.seen);
  view.detection_probability = detectionProbability(track.snr * view.loss, params.false_alarm_probability);
  return view;
}

FrameView viewOf(const FrameTrack& track, const Frame& frame, const ArrayPose& pose, const MfaStubParams& params) {
  FrameView view;
  double missed = 1.0, best = 0.0;
  for (const Dwell& dwell : frame.dwells) {
    const DwellView& one = view.dwells.emplace_back(viewOf(track, dwell, pose, params));
    missed *= 1.0 - one.detection_probability;
    if (one.detection_probability <= best) continue;
    best = one.detection_probability;
    view.time = dwell.time;
  }
  view.detection_probability = 1.0 - missed;
  return view;
}

}  // namespace esa_frame_builder
