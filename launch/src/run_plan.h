#pragma once

#include <string>
#include <vector>

#include "run_options.h"

namespace tws_launch {

/// What `./tws run`, `replay` or `offline` does with its words, as assignments for the shell: `folder` of the output,
/// and `launch`, a launch file that was written there, or `words` for tws_offline. `root`: where out/ is. Throws
/// UsageError, and std::runtime_error for an input that cannot be run.
std::string plannedRun(const std::string& command, const std::vector<std::string>& words, const std::string& root);

/// Refuses words of such a command that cannot be meant. Throws UsageError.
void checkWords(const std::string& command, const std::vector<std::string>& words);

/// Names of the scenarios of this package, sorted.
std::vector<std::string> scenarioNames();

/// The path of a file, or of a scenario of that name. Throws UsageError.
std::string inputFile(const std::string& name);

/// The launch file of a run; writes a configuration of RViz, whose scale fits the picture, to `rviz_config` when one
/// is needed.
std::string launchFileFor(const std::string& input, RunOptions options, const std::string& rviz_config);

}  // namespace tws_launch
