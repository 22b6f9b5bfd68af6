#pragma once

#include <string>
#include <vector>

namespace tws_launch {

/// What a run needs to know of its scenario or bag beforehand.
struct RunInput {
  std::string path;
  bool is_bag = false;
  std::vector<std::string> radars;  ///< Names of the rotating radars, by name.
  double length = 0.0;              ///< Data time from start to end [s]; 0: the scenario does not say.
};

/// Reads a scenario (whatever its name) or a bag (*.bag). Throws std::runtime_error that names the file when it cannot
/// be read or has no rotating radar.
RunInput inspectInput(const std::string& path);

}  // namespace tws_launch
