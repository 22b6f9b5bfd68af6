#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tws_launch {

/// What a run needs to know of its scenario, bag or ASTERIX recording beforehand.
struct RunInput {
  std::string path;
  bool is_bag = false;
  bool is_recording = false;        ///< Of ASTERIX.
  std::vector<std::string> radars;  ///< Names of the rotating radars, by name; of a recording only the busiest one.
  std::vector<std::string> secondary_radars;  ///< Of a scenario or bag, by name.
  std::vector<std::string> array_radars;      ///< Electronically scanned, of a scenario or bag, by name.
  std::vector<std::string> range_radars;      ///< Those that report range profiles, of a scenario or bag, by name.
  bool feeds_tracks = false;                  ///< Primary and secondary tracks come with it, in place of trackers.
  std::string windows;  ///< The radar that the window tracker of a recorded run heard; empty: none.
  double length = 0.0;  ///< Data time from start to end [s].
};

/// Whether a path is taken for a recorded run: it ends in ".bag".
bool isBag(const std::string& path);

/// Whether a path is taken for an ASTERIX recording: it ends neither as a bag nor in ".yaml" or ".yml", as scenarios
/// do.
bool isRecording(const std::string& path);

/// Reads a scenario, a bag or an ASTERIX recording, of which a run may be limited to a `duration` [s]. Throws
/// std::runtime_error, one line that names the file and, in a scenario, the line, when it cannot be read, is wrong or
/// has no primary radar.
RunInput inspectInput(const std::string& path, std::optional<double> duration = std::nullopt);

}  // namespace tws_launch
