#include <CLI/CLI.hpp>
#include <iostream>

#include "run_summary.h"

int main(int argc, char** argv) {
  CLI::App app("Says what happened in a recorded run.");
  std::string bag;
  std::optional<double> wall_time;
  app.add_option("bag", bag, "the recorded run")->required()->check(CLI::ExistingFile);
  app.add_option("--wall", wall_time, "wall time that the run took [s]");
  CLI11_PARSE(app, argc, argv);
  try {
    const auto summary = tws_launch::RunSummary::ofBag(bag);
    summary.print(std::cout, summary.counters(), wall_time);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "tws_summary: " << error.what() << std::endl;
    return 1;
  }
}
