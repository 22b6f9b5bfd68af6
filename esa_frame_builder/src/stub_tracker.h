#pragma once

#include <tws_core/assignment.h>

#include <optional>

#include "array_pose.h"
#include "frame_tracker.h"
#include "frame_view.h"
#include "merged_plot.h"
#include "mfa_stub_params.h"

namespace esa_frame_builder {

/// A frame tracker that decides about each frame as it closes: optimal assignment of its measurements to the tracks by
/// likelihood, with merged plots of several targets, a constant-velocity Kalman filter in space, and initiation by M
/// measurements in N frames, which counts frames and not time.
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
    std::size_t dwell;  // of the frame
    double time;        // [s]
    double snr;
    tws::SpatialMeasurement place;
  };
  /// A frame as the tracks see it.
  struct Scene {
    std::vector<const FrameTrack*> tracks;
    std::vector<FrameView> views;
    std::vector<Plot> plots;
  };
  /// A plot as a track would take it: as its own one, or as a merged one.
  struct Reading {
    tws::SpatialMeasurement measurement;
    tws::SpatialInnovation innovation;
    MergedPlot merged;  // without members: the track's own plot
  };
  /// What a track takes of a frame: a plot of its own, a share in that of another track, or nothing.
  struct Taken {
    std::optional<std::size_t> plot;
    bool is_own = false;
    Reading reading;
  };

  Scene sceneOf(const std::vector<Kept>& tracks, const Frame& frame) const;
  std::vector<Plot> plotsOf(const Frame& frame) const;
  Reading readingOf(const Scene& scene, std::size_t track, const Plot& plot) const;
  /// For each track its plot, or tws::AssignmentSolver::kUnassigned.
  std::vector<int> associate(const Scene& scene);
  void addPairs(const Scene& scene, std::size_t row);
  /// What each track takes of the plots.
  std::vector<Taken> take(const Scene& scene, const std::vector<int>& plot_of) const;
  void share(const Scene& scene, std::size_t giver, std::vector<Taken>& taken) const;
  /// Updates and scores the tracks; for each plot whether it was used.
  std::vector<bool> update(std::vector<Kept>& tracks, const Scene& scene, std::vector<TrackUpdate>& updates);
  void see(Kept& kept, const FrameView& view, const Plot& plot, const Taken& taken) const;
  void miss(Kept& kept, const FrameView& view, TrackUpdate& update) const;
  void initiate(const std::vector<Plot>& plots, const std::vector<bool>& used);
  void judge(const Frame& frame);
  bool isLost(const Kept& kept, double time) const;

  MfaStubParams params_;
  ArrayPose pose_;
  std::vector<Kept> tracks_;  // by number
  std::uint32_t last_number_ = 0;
  std::vector<TrackUpdate> updates_;  // since the last report
  tws::AssignmentSolver solver_;
  std::vector<tws::AssignmentSolver::Pair> pairs_;
};

}  // namespace esa_frame_builder
