#pragma once

#include <map>
#include <optional>
#include <string>

#include "graph_description.h"
#include "graph_file.h"
#include "run_options.h"
#include "tracker_choices.h"

namespace tws_launch {

enum class InputKind { kScenario, kBag, kRecording, kFeed };

/// What is in a scenario, a bag, an ASTERIX recording or a live feed: a graph follows from it.
struct RunInput {
  InputKind kind = InputKind::kScenario;
  std::string path;  ///< Absolute; empty: a live feed.
  Sensors sensors;
  std::string space;                          ///< The namespace of the bag's topics: "" or e.g. "/ship".
  std::map<std::string, std::string> remaps;  ///< Where the bag holds a sensor under another name than the usual one.
  std::map<std::string, std::string> topics;  ///< Of a bag: absolute name, and as it is recorded.
  TrackerChoices trackers;                    ///< What a scenario says of them, or what a bag's topics tell.
  std::optional<GraphDescription> recorded;   ///< The graph that a bag was recorded with.
  YAML::Node origin;                          ///< Of a scenario's map frame, as nodes take it; undefined: unknown.
  double length = 0.0;                        ///< Data time from start to end [s]; 0: unknown.

  /// Names of a kind's sensors; empty: none.
  std::vector<std::string> names(const std::string& sensor_kind) const;
};

/// Whether a path is taken for a recorded run: it begins as one, or its name ends in ".bag".
bool isBag(const std::string& path);

/// Whether a path is taken for an ASTERIX recording: it is no bag, and its name does not end in ".yaml" or ".yml".
bool isRecording(const std::string& path);

/// Refuses options that are not for such an input, before it is read. Throws UsageError.
void refuseOptions(const std::string& path, const RunOptions& options);

/// Reads what is in the input; an empty path: a live feed. Throws std::runtime_error, one line that names the file and,
/// in a scenario, the line, when it cannot be read, is wrong, cannot be understood or has no radar to track; and
/// UsageError for an option that is not for such an input.
RunInput inspectInput(const std::string& path, const GraphFile& file, const RunOptions& options = {});

}  // namespace tws_launch
