#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "mark_clock.h"

namespace track_correlator {

/// What one tracker says of a track.
struct TrackInput {
  std::uint32_t uid = 0;                            ///< Never used twice in one run of that tracker.
  double time = 0.0;                                ///< Position and velocity hold at this instant [s].
  Eigen::Vector4d state = Eigen::Vector4d::Zero();  ///< x, y [m], vx, vy [m/s]; the plane of slant range and azimuth.
  Eigen::Matrix4d covariance = Eigen::Matrix4d::Identity();
  bool dropped = false;  ///< The track's final update.
};

/// A track and what the correlator keeps of it.
struct KnownTrack {
  static constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::min() / 2;

  TrackInput input;
  std::uint32_t identity = 0;   ///< 0: not yet.
  std::int64_t done = kNever;   ///< Running sector in which it was processed last.
  std::int64_t taken = kNever;  ///< A secondary: served a primary last.
  int behind = 0;               ///< Sectors behind the one processed, when near it.
  std::int64_t next_look = kNever;

  /// On a straight line to another instant [s].
  Eigen::Vector4d at(double time) const;
  /// Once a turn; one or two sectors behind: it has moved against the beam, out of a sector that was still to come.
  bool isDue(std::int64_t running) const;
  /// Not processed in this turn yet.
  bool isFresh(std::int64_t running) const;
};

/// The living tracks of one tracker, by uid. Those that the beam is far from are not looked at in every sector: a track
/// moves across sectors more slowly than the beam.
class KnownTracks {
 public:
  void add(const TrackInput& track);
  KnownTrack* find(std::uint32_t uid);
  KnownTrack& at(std::uint32_t uid) { return tracks_.at(uid); }
  bool contains(std::uint32_t uid) const { return tracks_.count(uid) > 0; }
  void erase(std::uint32_t uid) { tracks_.erase(uid); }
  /// All count as processed in this sector last: the radar counts anew.
  void restart(std::int64_t running);

  /// Uids of the tracks whose latest update is older than `timeout` [s].
  std::vector<std::uint32_t> silentAt(double time, double timeout);

  using Near = std::vector<std::pair<std::uint32_t, KnownTrack*>>;
  /// The tracks that are at the mark's instant in its sector, up to one sector ahead or up to two behind; in order of
  /// their uids. Valid until a track is added or erased.
  const Near& nearTo(const Mark& mark);

 private:
  std::map<std::uint32_t, KnownTrack> tracks_;
  Near near_;
  double oldest_ = std::numeric_limits<double>::infinity();  // no latest update is older than this [s]
};

}  // namespace track_correlator
