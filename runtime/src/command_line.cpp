#include <tws_runtime/command_line.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>
#include <iostream>

namespace tws_runtime {
namespace {

/// What was said is only now on the disk or in the pipe, or is not.
bool isSaid() {
  std::cout.flush();
  return std::cout.good() && std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
}

}  // namespace

int guarded(const std::string& program, const std::function<int()>& run) noexcept {
  std::signal(SIGXFSZ, SIG_IGN);  // A file that grows too large is an error of a write, said as such.
  try {
    const int status = run();
    if (status != 0 || isSaid()) return status;
    std::fprintf(stderr, "%s: what it says cannot be written to the standard output\n", program.c_str());
    return 1;
  } catch (const std::exception& error) {
    std::cout.flush();  // The reason is the last that is read.
    std::fprintf(stderr, "%s: %s\n", program.c_str(), error.what());
    return 1;
  }
}

void addDuration(CLI::App& app, std::optional<double>& duration) {
  const auto check = [](const std::string& text) {
    double value = 0.0;
    const bool good = CLI::detail::lexical_cast(text, value) && value >= 1.0 && value <= 1e6;
    return good ? std::string() : "wants a number from 1 to 1000000, not " + text;
  };
  app.add_option("--duration", duration, "stop after so much data time [s]")->check(check);
}

std::optional<int> parseCommandLine(CLI::App& app, int argc, char** argv) {
  app.failure_message([](const CLI::App* failed, const CLI::Error& error) {
    return failed->get_name() + ": " + error.what() + " (" + failed->get_name() + " --help says more)\n";
  });
  try {
    app.parse(argc, argv);
    return std::nullopt;
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
}

}  // namespace tws_runtime
