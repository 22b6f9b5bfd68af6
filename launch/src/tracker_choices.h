#pragma once

#include <yaml-cpp/yaml.h>

#include <map>
#include <optional>
#include <string>

namespace tws_launch {

/// What a scenario or a person says of one node.
struct TrackerChoice {
  std::optional<bool> on;  ///< Whether it is part of the graph at all.
  std::string like;        ///< It is one more of the node of that name; empty: it is the one of its own name.
  std::string set;         ///< Its parameters: a name in its package's config, or the path of a file; empty: the usual.
  YAML::Node parameters;   ///< Of its own, over those of the set.
};

/// By the node's name.
using TrackerChoices = std::map<std::string, TrackerChoice>;

/// Reads what stands under the key `trackers` of a scenario: of each node a parameter set (`range_gate_tracker: ship`),
/// `on` or `off`, or a map of its parameters, in which `params` names a set and `like` another node of which it is one
/// more. Paths of files are meant from `folder`. Throws std::runtime_error, beginning with `where`.
TrackerChoices readTrackerChoices(const YAML::Node& tree, const std::string& folder, const std::string& where);

/// `choices` with what `later` says instead: a set, and single parameters.
TrackerChoices merged(TrackerChoices choices, const TrackerChoices& later);

/// Whether a parameter set is the path of a file, not a name.
bool isPath(const std::string& set);

}  // namespace tws_launch
