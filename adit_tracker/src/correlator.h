#pragma once

#include <cstdint>
#include <vector>

#include "adit_params.h"
#include "radar_state.h"
#include "track_file.h"

namespace adit_tracker {

/// A detection given to a track in the primary sector.
struct Correlation {
  TrackFile::Slot slot;
  Detection* detection;
};

/// The report's track correlator: several passes through the tracks with growing regions, so that the closest pairs are
/// made first. Tracks of two sectors ahead take part without being updated: what is closer to them is not taken by a
/// track in the primary sector. Cost of a sector: its tracks × (logarithm of the detections in three sectors +
/// detections in the largest region).
class Correlator {
 public:
  explicit Correlator(const AditParams& params) : params_(params) {}

  /// `primary`: tracks in the running sector that may be updated; `secondary`: those of the two sectors ahead; both in
  /// order of the sector files (firm first). Each track's prediction must be for this radar. The detections given away
  /// are marked as used.
  const std::vector<Correlation>& correlate(const TrackFile& tracks, const std::vector<TrackFile::Slot>& primary,
                                            const std::vector<TrackFile::Slot>& secondary, RadarState& radar,
                                            std::int64_t running);

 private:
  struct Candidate {
    Detection* detection;
    double distance;
    std::size_t gate;  // the smallest region that holds it
  };
  struct Entry {
    TrackFile::Slot slot;
    bool primary;
    bool correlated;
    std::size_t first, last;  // its candidates
  };

  struct Reach {
    double range, azimuth;
  };

  Reach reachOf(const Prediction& prediction) const;
  void gather(const Track& track, TrackFile::Slot slot, bool primary, RadarState& radar, std::int64_t sector);
  /// The smallest region that holds the detection, and its distance; kGates: none.
  std::size_t smallestGate(const Track& track, double range_difference, double azimuth_difference,
                           double& distance) const;
  void pass(std::size_t gate);
  Detection* closest(const Entry& entry, std::size_t gate) const;

  AditParams params_;
  std::uint64_t run_ = 0;  // flags of earlier runs do not count
  std::vector<Entry> entries_;
  std::vector<Candidate> candidates_;
  std::vector<Correlation> correlations_;
};

}  // namespace adit_tracker
