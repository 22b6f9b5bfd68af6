#pragma once

#include <string>

#include "clutter/clutter.h"
#include "random_stream.h"
#include "range_rates.h"

namespace radar_sim {

/// One object that is clutter: a bird, a turbine.
struct ClutterPoint {
  Eigen::Vector3d position;  ///< In the map frame, at height above the sea there [m].
  double rcs;                ///< Mean, behind suppression [m²]; Swerling 1.
  double jitter;             ///< Its echo's centre wanders so far, standard deviation in range and across [m].
  Motion motion = {};
};

/// How one radar sees such objects.
class PointView {
 public:
  PointView(const ClutterView& view, const std::string& stream);

  /// Appends the object's echo when it lies in the spoke and crosses the threshold. `number`: the object's, which keys
  /// the random numbers with the spoke.
  void raise(const ClutterPoint& point, std::size_t number, const Spoke& spoke, std::vector<Echo>& echoes) const;
  const RadarParams& params() const { return params_; }

 private:
  RadarParams params_;
  Eigen::Isometry3d map_to_site_;
  std::uint64_t seed_;
  std::uint64_t stream_, rate_stream_;
};

}  // namespace radar_sim
