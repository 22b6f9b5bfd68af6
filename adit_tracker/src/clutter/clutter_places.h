#pragma once

#include <string>
#include <vector>

#include "adit_params.h"

namespace adit_tracker {

/// Where clutter is known to stand, as it is saved and loaded.
struct ClutterPlace {
  std::string radar;     // in whose map; empty: in those of all radars
  double range = 0.0;    // slant range [m], (0, 10 000 km]
  double azimuth = 0.0;  // clockwise from true north [rad], [0, 2π)

  bool operator==(const ClutterPlace& o) const { return radar == o.radar && range == o.range && azimuth == o.azimuth; }
};

/// Which places the clutter maps take.
class ClutterLimits {
 public:
  explicit ClutterLimits(const AditParams& params);

  /// Why one more place cannot be used; empty: it can, and is counted.
  std::string add(const ClutterPlace& place);
  /// The names of those that there are.
  const std::vector<std::string>& radars() const { return radars_; }

 private:
  std::vector<std::string> radars_;
  bool per_radar_;
  std::uint32_t most_;               // points of one map
  std::vector<std::uint32_t> used_;  // of each map
};

}  // namespace adit_tracker
