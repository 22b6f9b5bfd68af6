#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <string>
#include <vector>

namespace track_evaluation {

/// What a bag holds that can be evaluated, wherever its topics stand.
struct BagContents {
  std::string space;  ///< The namespace that all of it shares, "" or e.g. "/ship"; the names below are relative to it.
  std::vector<std::string> trackers, correlators, radars, secondary_radars, array_radars;  ///< Sorted.
  std::string truth;                                                                       ///< Its topic; empty: none.
  bool transforms = false;
  YAML::Node origin;  ///< Of the map frame, as the evaluation takes it: the recorded graph says it; null: unknown.

  std::vector<std::string> topics() const;  ///< All of them, and /tf_static when it is there; absolute.
  /// The truth where the evaluation looks for it.
  std::map<std::string, std::string> remaps() const;
};

/// Throws std::runtime_error, one line that names the file, when it is missing, truncated, no bag, or holds no tracks.
BagContents inspectBag(const std::string& path);

}  // namespace track_evaluation
