#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <tws_core/sector_order.h>
#include "adit_params.h"
#include "core/correlator.h"
#include "core/radar_state.h"
#include "core/track_file.h"
#include "core/track_motion.h"

namespace adit_tracker {

/// Track bifurcation, which the report names as work in hand ("Current Status"): what is done about targets so close to
/// each other that a radar gives one detection for them.
///
/// - Two tracks, one merged plot (crossings, formations): the detection lies somewhere between both targets. It
///   corrects both tracks by as much as it says of each, and neither counts as missed.
/// - Two plots, one track (targets part): the detection that is left over starts a branch, a tentative track that has
///   its parent's velocity and becomes firm with fewer detections.
///
/// Cost: for a track without a detection, or a detection that is left over, the detections in range of it; nothing for
/// any other.
class Bifurcation {
 public:
  explicit Bifurcation(const AditParams& params);

  /// After the correlation of a sector: finds the tracks without a detection that share one with another track.
  /// `primary`: as in Correlator::correlate.
  void share(const TrackFile& tracks, const TrackMotion& motion, const Correlator& correlator,
             const std::vector<Correlation>& pairs, const std::vector<TrackFile::Slot>& primary, RadarState& radar,
             const tws::SectorRef& sector);

  /// The detection in which a track without one of its own is merged; nullptr: it is in none.
  const Detection* mergedPlotOf(TrackFile::Slot slot) const;
  /// What a detection that several targets share says of this one: its plot, moved by as much as the track's own target
  /// lies off it, its errors enlarged by what is not known of that. nullptr: the detection is not shared.
  const tws::Plot* asSeenBy(const Track& track, const Detection& detection) const;
  /// Has the track been unresolved for so long that it no longer counts as another target?
  bool hasMerged(const Track& track, const Detection& detection) const;

  /// What an unused detection of the sector before the running one split from; nothing: it did not split.
  std::optional<Parting> partingOf(const TrackFile& tracks, const Detection& detection, RadarState& radar,
                                   const tws::SectorRef& sector) const;

 private:
  /// Half-widths [m], [rad].
  struct Reach {
    double range, azimuth;
  };
  /// A track that is hidden in the detection of another.
  struct Shared {
    const Detection* detection;
    std::int64_t running;
    const RadarState* radar;
    TrackFile::Slot slot;
    std::uint32_t uid, taker;  // identities
    tws::Plot for_hidden, for_taker;
  };

  Reach cellOf(const RadarQuality& quality) const;
  Reach partingReach(const tws::Plot& plot, const RadarState& radar, double speed) const;
  const PartingParams& partingIn(const Track& track) const { return params_.in(track.volume).parting; }
  /// Of one run of share().
  struct Run {
    const TrackFile& tracks;
    const TrackMotion& motion;
    const Correlator& correlator;
    RadarState& radar;
    const tws::SectorRef& sector;
  };
  static bool areWithinHalf(const Reach& cell, const Track& a, const Track& b);
  void learnResolution(const Run& run, const std::vector<Correlation>& pairs) const;
  void tryToShare(const Run& run, TrackFile::Slot slot);
  std::optional<Shared> shareOf(const Run& run, const Track& hidden, const Track& taker,
                                const Detection& detection) const;
  void weigh(Parting& parting, const Track& parent, const tws::Plot& plot, const RadarState& radar,
             std::size_t radar_index) const;
  bool isShared(const Detection& detection) const;

  AditParams params_;
  double greatest_speed_;                    // of parting, anywhere [m/s]
  std::vector<Shared> shared_;               // in the latest sectors, of all radars
  std::size_t now_ = 0;                      // those from here on are of the running sector
  std::vector<TrackFile::Slot> correlated_;  // kept to save allocations
};

}  // namespace adit_tracker
