#include <tws_runtime/command_line.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "in_words.h"
#include "run_input.h"

int main(int argc, char** argv) {
  return tws_runtime::guarded("tws_inspect", [&] {
    CLI::App app(
        "Says what the launch files want to know of a scenario, bag or ASTERIX recording, as arguments for them, one a "
        "line.",
        "tws_inspect");
    std::string path;
    app.add_option("input", path, "scenario (*.yaml), recorded run (*.bag) or ASTERIX recording")
        ->required()
        ->check(CLI::ExistingFile);
    std::optional<double> duration;
    tws_runtime::addDuration(app, duration);
    if (const auto status = tws_runtime::parseCommandLine(app, argc, argv)) return *status;
    const tws_launch::RunInput input = tws_launch::inspectInput(path, duration);
    std::cout << "radars:=" << (input.radars.empty() ? "none" : tws_launch::joined(input.radars));
    // Not a word of them where there are none: the launch file for recordings does not know the argument.
    if (!input.secondary_radars.empty())
      std::cout << "\nsecondary_radars:=" << tws_launch::joined(input.secondary_radars);
    if (!input.array_radars.empty()) std::cout << "\narray_radars:=" << tws_launch::joined(input.array_radars);
    if (!input.range_radars.empty()) std::cout << "\nrange_radars:=" << tws_launch::joined(input.range_radars);
    if (input.feeds_tracks) std::cout << "\nfed:=true";
    if (!input.windows.empty()) std::cout << "\nwindows:=" << input.windows;
    std::cout << "\nlength:=" << input.length << std::endl;
    return 0;
  });
}
