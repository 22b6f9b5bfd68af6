#pragma once

#include <functional>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace track_evaluation {

/// Runs a program: what it throws becomes one line on the standard error and exit status 1.
int guarded(const std::string& program, const std::function<int()>& run) noexcept;
/// The exit status when the command line asks for help (0) or is wrong (2, one line on the standard error).
std::optional<int> parse(CLI::App& app, int argc, char** argv);

}  // namespace track_evaluation
