#pragma once

#include "adit_params.h"
#include "core/radar_state.h"
#include "core/track.h"

namespace adit_tracker {

/// Decides when a tentative track becomes firm and when a track ends: by the report's timers TFIX, TNMAX, TTMAX, or by
/// the chance that there is a target, which each detection raises by how well it fits and each missed illumination
/// lowers.
class TrackJudge {
 public:
  explicit TrackJudge(const AditParams& params) : params_(params) {}

  void started(Track& track, const RadarQuality& quality) const;
  /// A detection with this log-likelihood [1/m²] was used. Returns true when the track has just become firm.
  bool updated(Track& track, std::size_t radar, double log_likelihood, const RadarQuality& quality,
               bool may_become_firm = true) const;
  /// The beam has passed at `time` and nothing was found. Returns true when the track is to be dropped.
  bool missed(Track& track, std::size_t radar, double time) const;
  /// The beam has passed at `time`, and what was found may have been this track's target or another one.
  void unresolved(Track& track, double time) const;

  /// Firm, and not in doubt.
  bool confirmed(const Track& track) const {
    return track.firm && (params_.life == TrackLife::kTimers || track.existence >= params_.existence.doubt_probability);
  }

 private:
  void age(Track& track, double time) const;
  bool deservesFirm(const Track& track) const;

  AditParams params_;
};

}  // namespace adit_tracker
