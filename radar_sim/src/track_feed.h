#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include <tws_core/plot.h>

#include "target.h"

namespace radar_sim {

/// Tracks in place of trackers, for scenes in which no radar separates the plots.
struct TrackFeedParams {
  std::string clock_radar;      ///< The primary radar by whose sectors, and from whose site, the tracks are stated.
  double position_sigma = 8.0;  ///< Of a track's position in x and in y [m], >= 0.
  double velocity_sigma = 5.0;  ///< Of its velocity in x and in y [m/s], >= 0.
};

enum class FeedKind { kPrimary, kSecondary };

/// A track update of one target.
struct FedTrack {
  std::size_t target = 0;    ///< Index among the targets.
  std::uint32_t number = 0;  ///< From 1; never used twice.
  bool dropped = false;      ///< Its final update, which repeats the one before.
  double time = 0.0;         ///< Of the state [s of data time].
  double first_time = 0.0;   ///< Of the track's first update [s of data time].
  /// x east, y north and their rates on the plane of slant range and azimuth, from the clock radar [m, m/s].
  Eigen::Vector4d state = Eigen::Vector4d::Zero();
  double height = std::numeric_limits<double>::quiet_NaN();  ///< Above the sea [m]; NaN for a primary track.
};

/// The tracks of one kind: of each aircraft or ship one update a scan, when the beam of the clock radar has passed it,
/// with errors that are independent from scan to scan. A secondary track needs a transponder; when that falls silent,
/// even for a moment, the track is dropped, and what comes after has another number.
///
/// The errors come from streams keyed by the seed, the kind, the target's name and the scan: another target changes
/// none of them.
class TrackFeed {
 public:
  /// `targets` must outlive the feed.
  TrackFeed(FeedKind kind, TrackFeedParams params, const Eigen::Isometry3d& map_to_radar,
            const std::vector<Target>& targets, std::uint64_t seed);

  FeedKind kind() const { return kind_; }
  const TrackFeedParams& params() const { return params_; }
  const Eigen::Isometry3d& mapToRadar() const { return map_to_radar_; }
  /// The updates of one sector of the clock radar, stated for the instant at which the beam entered it. Sectors must
  /// come in order.
  std::vector<FedTrack> tracksOf(const tws::RadarSector& sector);

 private:
  struct Life {  // of a target
    FedTrack update;
    bool alive = false;
    std::int64_t updated = std::numeric_limits<std::int64_t>::min() / 2;  // running sector of the latest update
  };

  bool existsAt(const Target& target, double time) const;
  Eigen::Vector4d stateOf(const TargetState& truth) const;
  void addErrors(const Target& target, std::int64_t scan, Eigen::Vector4d& state) const;

  FeedKind kind_;
  TrackFeedParams params_;
  Eigen::Isometry3d map_to_radar_;
  const std::vector<Target>& targets_;
  std::uint64_t seed_;
  std::vector<Life> lives_;
  std::uint32_t last_number_ = 0;
};

}  // namespace radar_sim
