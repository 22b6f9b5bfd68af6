#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <tws_core/angles.h>

#include "radar_params.h"
#include "resolution.h"

namespace radar_sim {

/// One beamwidth of azimuth while the beam passes over it. Clutter is raised spoke by spoke; spokes lie at the same
/// azimuths on every scan, so that a resolution cell is the same piece of the world then.
struct Spoke {
  std::int64_t running;  ///< Counted on from scan to scan; keys the random numbers.
  std::int64_t number;   ///< In its scan.
  double from;           ///< Azimuth at which it begins [rad], [0, 2π).
  double width;          ///< [rad]
  double time;           ///< At which the beam enters it [s of data time].
  double duration;       ///< [s]

  /// `part`: of the spoke, 0 .. 1.
  double azimuthAt(double part) const { return tws::wrapTwoPi(from + part * width); }
  double timeAt(double part) const { return time + part * duration; }
  /// The part of an azimuth [rad]; 1 or more: it lies in another spoke.
  double partOf(double azimuth) const { return tws::wrapTwoPi(azimuth - from) / width; }
};

/// How many spokes a scan has; `beamwidth` [rad].
inline double spokes(double beamwidth) { return std::ceil(tws::kTwoPi / beamwidth); }

/// The radar that looks.
struct ClutterView {
  RadarParams params;
  Eigen::Isometry3d map_to_site;  ///< Map to the antenna's east, north, up.
  std::uint64_t seed;
};

/// Clutter as one radar sees it.
class Clutter {
 public:
  virtual ~Clutter() = default;
  /// Appends what crosses the threshold in that spoke. The same call gives the same echoes.
  virtual void raise(const Spoke& spoke, std::vector<Echo>& echoes) = 0;
};

/// Clutter as a scenario describes it: the same for all radars. Its places are east, north in the map frame [m].
struct ClutterSpec {
  virtual ~ClutterSpec() = default;

  std::string name;                 ///< Unique; keys its random numbers.
  std::vector<std::string> radars;  ///< That see it; none: all rotating primary radars.
  double from = 0.0;                ///< It is there in [from, to) [s of data time].
  double to = std::numeric_limits<double>::infinity();
  double suppression = 1.0;  ///< Power ratio by which a radar's processing (MTI, STC, CFAR) weakens it.

  bool existsAt(double time) const { return time >= from && time < to; }
  bool isSeenBy(const std::string& radar) const;

  virtual std::unique_ptr<Clutter> seenBy(const ClutterView& view) const = 0;
  /// Where it is, for the truth: points of its outline, or its objects; at most kMostOutlinePoints. None: everywhere.
  virtual std::vector<Eigen::Vector2d> outlineAt(double time) const = 0;
};

constexpr std::size_t kMostOutlinePoints = 1024;

}  // namespace radar_sim
