#pragma once

#include <tws_core/assignment.h>

#include "array_pose.h"
#include "frame_tracker.h"
#include "frame_view.h"
#include "mfa_stub_params.h"

namespace esa_frame_builder {

/// A frame tracker that decides about each frame as it closes: optimal assignment of its measurements to the tracks by
/// likelihood, a constant-velocity Kalman filter in space, and initiation by M measurements in N frames, which counts
/// frames and not time.
class StubTracker : public FrameTracker {
 public:
  StubTracker(const MfaStubParams& params, const ArrayPose& pose) : params_(params), pose_(pose) {}

  void take(const FrameWindow& window) override;
  TrackReport report(const FrameWindow& window) override;

 private:
  struct Kept {
    FrameTrack track;
    int hits = 1, frames = 1;  // since it was started, that frame included
    double best_score = 0.0;
  };
  struct Plot {
    double time;
    double snr;  // as if at the beam's centre it had been what it was
    tws::SpatialMeasurement place;
  };

  std::vector<Plot> plotsOf(const Frame& frame) const;
  std::vector<int> associate(const std::vector<Kept>& tracks, const std::vector<FrameView>& views,
                             const std::vector<Plot>& plots);
  void addPairs(std::size_t row, const Kept& kept, const FrameView& view, const std::vector<Plot>& plots);
  /// Updates and scores the tracks; the number of the track, if any, that each plot went to.
  std::vector<bool> update(std::vector<Kept>& tracks, const Frame& frame, const std::vector<Plot>& plots,
                           std::vector<TrackWord>& words);
  void see(Kept& kept, const Plot& plot, double chance) const;
  void miss(Kept& kept, const FrameView& view, TrackWord& word) const;
  void initiate(const std::vector<Plot>& plots, const std::vector<bool>& used);
  void judge(const Frame& frame);
  bool isLost(const Kept& kept, double time) const;

  MfaStubParams params_;
  ArrayPose pose_;
  std::vector<Kept> tracks_;  // by number
  std::uint32_t last_number_ = 0;
  std::vector<TrackWord> words_;  // since the last report
  tws::AssignmentSolver solver_;
  std::vector<tws::AssignmentSolver::Pair> pairs_;
};

}  // namespace esa_frame_builder
