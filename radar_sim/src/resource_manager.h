#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "array_beam.h"
#include "search_raster.h"

namespace radar_sim {

/// A track as the resource manager sees it, predicted to the resource period.
struct SteerableTrack {
  std::uint32_t number;
  BeamPoint direction;
  double last_update;  ///< [s of data time]
  int priority;        ///< 0 is the least.
  double revisit;      ///< Wanted time between dwells [s].
};

/// A dwell that the resource manager has committed.
struct PlannedDwell {
  static constexpr std::uint32_t kNoGroup = 0;

  BeamPoint beam;
  bool is_track_dwell = false;
  std::vector<std::uint32_t> expected;  ///< Dwell group indices: tracks within its half-power contour, ascending.
  std::uint32_t group = kNoGroup;       ///< The sequence of overlapping beams that it is part of.
  std::uint32_t group_dwells = 0;       ///< Beams of that sequence; 0: none.
};

/// Plans the dwells of an array, resource period by resource period, from the tracks of its tracker (Slocumb & Klusman,
/// section 2).
///
/// A track is due when its revisit time has gone by since the last dwell on it, or since its last update before there
/// was any. Tracks that lie close together, one to the next, are visited together when one of them is due, by a
/// sequence of overlapping beams. Sequences go by priority, then by how long they have been due; the limiter cuts the
/// list where the period is full. A sequence that was cut in two goes on at the begin of the next period; others wait
/// and are planned anew. The rest of the period, and never less than its share, goes to the search raster.
class ResourceManager {
 public:
  /// Throws as SearchRaster.
  explicit ResourceManager(const ArrayParams& array);

  /// The dwells of the period that begins at `time` [s of data time], in their order.
  std::vector<PlannedDwell> plan(double time, const std::vector<SteerableTrack>& tracks);

  /// Dwells that fit into one period.
  std::size_t capacity() const { return capacity_; }

 private:
  /// Tracks that are visited together: indices into the tracks.
  struct Visit {
    std::vector<std::size_t> members;
    int priority = 0;
    double due = 0.0;
  };

  double dueTime(const SteerableTrack& track) const;
  std::vector<Visit> dueVisits(double end, const std::vector<SteerableTrack>& tracks) const;
  std::vector<PlannedDwell> sequence(const Visit& visit, const std::vector<SteerableTrack>& tracks);
  void forgetOthers(const std::vector<SteerableTrack>& tracks);

  ArrayParams array_;
  SearchRaster raster_;
  std::size_t capacity_;
  std::map<std::uint32_t, double> last_dwells_;  ///< By track [s of data time].
  std::vector<PlannedDwell> rest_;               ///< Of a sequence that was cut.
  std::uint32_t groups_ = 0;
};

/// Sets of tracks, as indices, each of which lies closer than `array.sequence_distance` to another one of its set.
std::vector<std::vector<std::size_t>> closeTogether(const ArrayParams& array,
                                                    const std::vector<SteerableTrack>& tracks);

/// When the next dwell on a track is expected: the earliest of last update plus revisit time (equations (32) and (33)),
/// but not before `now`. Nothing without tracks.
std::optional<double> nextExpectedDwell(const std::vector<SteerableTrack>& tracks, double now);

}  // namespace radar_sim
