#include <CLI/CLI.hpp>
#include <iostream>

#include "command_line.h"
#include "run_input.h"

int main(int argc, char** argv) {
  return tws_launch::guarded("tws_inspect", [&] {
    CLI::App app(
        "Says what the launch files want to know of a scenario, bag or ASTERIX recording, as arguments for them, one a "
        "line.",
        "tws_inspect");
    std::string path;
    app.add_option("input", path, "scenario (*.yaml), recorded run (*.bag) or ASTERIX recording")
        ->required()
        ->check(CLI::ExistingFile);
    std::optional<double> duration;
    tws_launch::addDuration(app, duration);
    if (const auto status = tws_launch::parse(app, argc, argv)) return *status;
    const tws_launch::RunInput input = tws_launch::inspectInput(path, duration);
    std::cout << "radars:=";
    for (std::size_t i = 0; i < input.radars.size(); ++i) std::cout << (i > 0 ? " " : "") << input.radars[i];
    std::cout << "\nlength:=" << input.length << std::endl;
    return 0;
  });
}
