#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "adit_params.h"
#include "core/candidates.h"
#include "core/cluster_weigher.h"
#include "core/radar_state.h"
#include "core/track_file.h"

namespace adit_tracker {

/// Which track gets which detection. The report's track correlator: several passes through the tracks with growing
/// regions, so that the closest pairs are made first. Tracks of two sectors ahead take part without being updated: what
/// is closer to them is not taken by a track in the primary sector; those that cannot matter are passed over. Cost of a
/// sector: its tracks × the detections in range of the largest region: where N false ones lie close together and start
/// as many tracks, N², of some nanoseconds. `association: chances` gathers the same tracks and detections and gives
/// them to the ClusterWeigher in place of the passes.
class Correlator {
 public:
  explicit Correlator(const AditParams& params) : params_(params) {}

  /// `primary`: tracks in the running sector that may be updated; `secondary`: those of the two sectors ahead; both in
  /// order of the sector files of the radar's site (firm first). Each track's prediction must be for this radar. The
  /// detections given away are marked as used, or as what is left of them.
  const std::vector<Correlation>& correlate(const TrackFile& tracks, const std::vector<TrackFile::Slot>& primary,
                                            const std::vector<TrackFile::Slot>& secondary, RadarState& radar,
                                            std::int64_t running, std::size_t site = 0);

  /// From now on, detections bear the claims of all tracks that want them.
  void keepClaims() { keeps_claims_ = true; }

  /// What the weighed correlations of the last run refer to.
  const std::vector<PlotChance>& chances() const { return weigher_.chances(); }

  /// Of the last run: calls `take(slot)` for each secondary track in whose region lay detections, but none was left for
  /// it.
  template <class Take>
  void forEachSecondaryLeftOut(const Take& take) const {
    for (const Entry& entry : entries_) {
      if (!entry.primary && !entry.correlated) take(entry.slot);
    }
  }
  /// Was the detection given to a track, in the last run or before it?
  bool isTaken(const Detection& detection) const {
    return detection.isGiven() || (detection.taker != Detection::kNoTaker && detection.flagged_in == run_);
  }

 private:
  struct Reach {
    double range, azimuth;
  };
  /// A track and its largest region.
  struct Asker {
    TrackFile::Slot slot;
    std::size_t order;  // who asks first
    bool primary;
    std::int64_t sector;  // running number
    Reach reach;
    bool asked;
  };

  /// How far clockwise the candidates lie, by range.
  class Frontier {
   public:
    /// For the sectors around this one, whose detections tell how many bins are worth while.
    void clear(DetectionFile& detections, std::int64_t sector);
    void add(double range, double azimuth);
    /// Might a candidate be in this region? Never no when there is one.
    bool meets(const Prediction& middle, const Reach& reach) const;

   private:
    std::size_t binOf(double range) const;

    double azimuth_ = 0.0;  // counted from here [rad]
    double bin_ = 1.0;      // [m]
    std::vector<double> farthest_;
  };

  bool byChances() const { return params_.association == Association::kChances; }
  double manoeuvreOf(const Track& track) const;
  ClusterWeigher::Resolution resolutionOf(const RadarQuality& quality) const;
  Reach reachOf(const Track& track) const;
  void beginNotes(Detection& detection, const FalsePlotMap& map) const;
  bool mayBeOf(const Track& track, Candidate& candidate, const std::optional<RateMatch>& rate, double range_difference,
               double azimuth_difference, double farthest, const RadarQuality& quality) const;
  void gather(const Track& track, const Asker& asker, RadarState& radar);
  void gatherPrimary(const TrackFile& tracks, const std::vector<TrackFile::Slot>& slots, RadarState& radar,
                     std::int64_t running);
  void gatherSecondary(const TrackFile& tracks, const std::vector<TrackFile::Slot>& slots, RadarState& radar,
                       std::int64_t running, std::size_t site);
  /// The smallest region that holds the detection, and its distance; kGates: none.
  std::size_t smallestGate(const Track& track, const tws::Plot& plot, const RadarQuality& quality,
                           const std::optional<RateMatch>& rate, double range_difference, double azimuth_difference,
                           double& distance) const;
  void pass(std::size_t gate);
  void noteClaims(const TrackFile& tracks) const;
  Detection* closest(const Entry& entry, std::size_t gate) const;

  AditParams params_;
  std::uint64_t run_ = 0;  // flags of earlier runs do not count
  bool keeps_claims_ = false;
  Frontier frontier_;
  std::vector<Asker> secondary_;
  std::vector<Entry> entries_;
  std::vector<Candidate> candidates_;
  std::vector<Correlation> correlations_;
  ClusterWeigher weigher_;
};

}  // namespace adit_tracker
