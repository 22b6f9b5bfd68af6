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

  /// `false_plots`: expected a scan, if they came as densely everywhere as there; of its range rate, fewer or more.
  void started(Track& track, double false_plots) const;
  /// A detection with this log-likelihood [1/m²], of its range rate against that of false plots, was used, where false
  /// plots have this density [1/m²]. Returns true when the track has just become firm.
  bool updated(Track& track, std::size_t radar, double log_likelihood, double false_density,
               bool may_become_firm = true) const;
  /// The beam has passed at `time`, and what was found leaves the track this chance of existence; `missed` is the
  /// chance that its target was not detected. Returns true when the track has just become firm.
  bool weighed(Track& track, std::size_t radar, double time, double existence, double missed,
               bool may_become_firm = true) const;
  /// Is the chance of existence too low to go on?
  bool isOver(const Track& track) const;
  /// The beam has passed at `time` and nothing was found. Returns true when the track is to be dropped.
  bool missed(Track& track, std::size_t radar, double time) const;
  /// The beam has passed at `time`, and what was found may have been this track's target or another one.
  void unresolved(Track& track, double time) const;

  /// That it follows a target, 0 to 1; a track that lives by timers is taken to.
  double chanceOf(const Track& track) const {
    return params_.life == TrackLife::kTimers ? 1.0 : static_cast<double>(track.existence);
  }
  /// Firm, and not in doubt.
  bool confirmed(const Track& track) const {
    return track.firm && (params_.life == TrackLife::kTimers ||
                          track.existence >= params_.in(track.volume).existence.doubt_probability);
  }

 private:
  void age(Track& track, double time) const;
  bool deservesFirm(const Track& track) const;
  bool becomesFirm(Track& track, bool may_become_firm) const;

  AditParams params_;
};

}  // namespace adit_tracker
