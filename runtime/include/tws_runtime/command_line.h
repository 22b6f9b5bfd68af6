#pragma once

#include <functional>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace tws_runtime {

/// Exit status of a program whose body is `run`: what that returns, or 1 after an exception or when the standard output
/// is full; the reason has then gone to the standard error in one line.
int guarded(const std::string& program, const std::function<int()>& run) noexcept;

/// The option --duration: seconds of data time, 1 to 1 000 000, as the simulator takes them.
void addDuration(CLI::App& app, std::optional<double>& duration);

/// Reads the command line. Nothing: go on; else the exit status: 0 after --help, 2 after bad usage, which was then said
/// in one line.
std::optional<int> parseCommandLine(CLI::App& app, int argc, char** argv);

}  // namespace tws_runtime
