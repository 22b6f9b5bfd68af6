#include <tws_runtime/command_line.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

namespace tws_runtime {

int guarded(const std::string& program, const std::function<int()>& run) noexcept {
  try {
    return run();
  } catch (const std::exception& error) {
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
