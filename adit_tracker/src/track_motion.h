#pragma once

#include "adit_params.h"
#include "radar_state.h"
#include "track.h"

namespace adit_tracker {

/// Position, velocity and, with the turning filter, covariance of (x, y, vx, vy) at one instant.
struct Extrapolation {
  Kinematics kinematics;
  bool has_covariance = false;
  PlanarState planar;
};

/// How tracks move: starts, corrects and extrapolates them by the filter that the parameters choose.
class TrackMotion {
 public:
  explicit TrackMotion(const AditParams& params);

  /// The track's first detection: at rest, where the plot is (section "Track Initiation").
  void start(Track& track, const tws::Plot& plot, const RadarQuality& quality) const;

  /// Corrects by a detection. Returns the natural logarithm of its likelihood [1/m²]; 0 with the α-β filter.
  double update(Track& track, const tws::Plot& plot, const RadarQuality& quality) const;

  /// Where the track is at `time`, which may be before the latest update by a little.
  Extrapolation at(const Track& track, double time) const;

  /// Sets track.predicted for an illumination by a radar.
  void predict(Track& track, std::size_t radar, double time, const RadarQuality& quality) const;

 private:
  void updatePolar(Track& track, const tws::Plot& plot) const;
  double updateTurning(Track& track, const tws::Plot& plot, const RadarQuality& quality) const;

  AditParams params_;
  tws::AdaptiveAlphaBeta alpha_beta_;
};

}  // namespace adit_tracker
