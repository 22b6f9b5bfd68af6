#pragma once

#include "array_pose.h"
#include "frame_tracker.h"
#include "mfa_stub_params.h"

namespace esa_frame_builder {

/// How one dwell sees one track.
struct DwellView {
  tws::SpatialState state;  // predicted to the dwell
  ArrayView seen;
  double loss = 0.0;  // of signal, 1: none; 0: the dwell cannot see it
  double detection_probability = 0.0;
};

/// How all dwells of a frame see one track.
struct FrameView {
  std::vector<DwellView> dwells;
  double detection_probability = 0.0;  // in at least one of the dwells
  double time = 0.0;                   // of the dwell that sees it best [s]
};

/// Loss of signal of a target off the beam's centre, two ways, for a Gaussian beam, averaged over the uncertainty of
/// the target's direction; 1: none.
double beamLoss(const Dwell& dwell, const ArrayView& view);

/// Swerling 1 after one dwell: P_d = P_fa^(1/(1 + snr)).
double detectionProbability(double snr, double false_alarm_probability);

FrameView viewOf(const FrameTrack& track, const Frame& frame, const ArrayPose& pose, const MfaStubParams& params);

}  // namespace esa_frame_builder
