#include <tws_runtime/command_line.h>

#include <CLI/CLI.hpp>
#include <iostream>
#include <stdexcept>

#include "run_summary.h"

int main(int argc, char** argv) {
  return tws_runtime::guarded("tws_summary", [&] {
    CLI::App app("Says what happened in a recorded run.", "tws_summary");
    std::string bag;
    std::optional<double> wall_time;
    app.add_option("bag", bag, "the recorded run")->required()->check(CLI::ExistingFile);
    app.add_option("--wall", wall_time, "wall time that the run took [s]");
    if (const auto status = tws_runtime::parseCommandLine(app, argc, argv)) return *status;
    const auto summary = tws_launch::RunSummary::ofBag(bag);
    summary.print(std::cout, summary.counters(), wall_time);
    const std::string failure = summary.failure();
    if (!failure.empty()) throw std::runtime_error(failure);
    return 0;
  });
}
