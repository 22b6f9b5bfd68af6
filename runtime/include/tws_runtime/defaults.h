#pragma once

#include <functional>
#include <string>
#include <vector>

namespace tws_runtime {

/// For tests: what a parameter file says otherwise than the code does without it. Runs `reading`, which reads the file
/// by ParameterReaders, and returns a line for each key whose value is not the one that its variable had before.
/// Entries of lists of maps have no default and are left out.
std::vector<std::string> departuresFromDefaults(const std::function<void()>& reading);

}  // namespace tws_runtime
