#pragma once

#include <string>
#include <vector>

namespace track_evaluation {

/// What a bag holds that can be evaluated, by the names of nodes, sorted.
struct BagContents {
  std::vector<std::string> trackers, correlators, radars, secondary_radars, array_radars;
  bool truth = false;
  std::vector<std::string> topics() const;  ///< All of them, and /tf_static when it is there.
  bool transforms = false;
};

/// Throws std::runtime_error, one line that names the file, when it is missing, truncated, no bag, or holds no tracks.
BagContents inspectBag(const std::string& path);

}  // namespace track_evaluation
