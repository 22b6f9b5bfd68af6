#include <tws_runtime/bag_source.h>
#include <tws_runtime/command_line.h>
#include <tws_runtime/run.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>

#include "in_words.h"
#include "offline_graph.h"
#include "recorded_requests.h"
#include "run_input.h"

namespace {

volatile std::sig_atomic_t interrupted = 0;

struct Options {
  std::string input;
  std::string out = ".";
  std::string params = "default";
  std::string clutter_map;
  std::string correlator;
  std::string windows;
  std::string window_params;
  std::string frame_builder;
  std::string range_params;
  std::string mfa_stub;
  std::optional<std::int64_t> seed;
  std::optional<double> duration;
};

/// Empty: a seed.
std::string seedProblem(const std::string& text) {
  std::int64_t seed = -1;
  const bool good = CLI::detail::lexical_cast(text, seed) && seed >= 0;
  return good ? "" : "wants a whole number from 0, not " + text;
}

/// The launch file of this input, and the argument that takes its path.
std::pair<std::string, std::string> launchFileOf(const tws_launch::RunInput& input) {
  if (input.is_bag) return {"replay.launch", "bag"};
  if (input.is_recording) return {"asterix.launch", "file"};
  return {"run.launch", "scenario"};
}

/// The graph that roslaunch would start for this input.
std::vector<tws_launch::NodeDescription> describe(const Options& options, const tws_launch::RunInput& input) {
  const auto [launch_file, argument] = launchFileOf(input);
  std::vector<std::string> arguments{"radars:=" + (input.radars.empty() ? "none" : tws_launch::joined(input.radars)),
                                     "params:=" + options.params, "rviz:=false",
                                     "length:=" + std::to_string(input.length), argument + ":=" + input.path};
  if (!input.is_recording) {
    arguments.push_back("secondary_radars:=" + tws_launch::joined(input.secondary_radars));
    arguments.push_back("array_radars:=" + tws_launch::joined(input.array_radars));
    arguments.push_back("range_radars:=" + tws_launch::joined(input.range_radars));
  }
  if (!options.range_params.empty()) arguments.push_back("range_params:=" + options.range_params);
  if (input.feeds_tracks) arguments.emplace_back("fed:=true");
  if (!options.clutter_map.empty())
    arguments.push_back("clutter_map:=" + std::filesystem::absolute(options.clutter_map).string());
  if (!options.correlator.empty())
    arguments.push_back("correlator:=" + std::filesystem::absolute(options.correlator).string());
  const std::string& windows = options.windows.empty() ? input.windows : options.windows;
  if (!windows.empty()) arguments.push_back("windows:=" + windows);
  if (!options.window_params.empty())
    arguments.push_back("window_params:=" + std::filesystem::absolute(options.window_params).string());
  if (!options.frame_builder.empty())
    arguments.push_back("frame_builder:=" + std::filesystem::absolute(options.frame_builder).string());
  if (!options.mfa_stub.empty())
    arguments.push_back("mfa_stub:=" + std::filesystem::absolute(options.mfa_stub).string());
  if (options.seed) arguments.push_back("seed:=" + std::to_string(*options.seed));
  return tws_launch::describeGraph(launch_file, arguments);
}

void run(const Options& options) {
  const auto start = std::chrono::steady_clock::now();
  const auto input = tws_launch::inspectInput(std::filesystem::absolute(options.input).string(), options.duration);
  tws_launch::OfflineGraph offline(describe(options, input), std::cerr);
  std::filesystem::create_directories(options.out);
  const std::string output = options.out + "/run.bag";
  if (std::filesystem::exists(output) && std::filesystem::equivalent(output, input.path))
    throw std::runtime_error(output + ": is the input itself; name another folder by --out");
  offline.graph().record(output);
  std::vector<tws_runtime::Source*> sources = offline.sources();
  std::unique_ptr<tws_runtime::BagSource> bag;
  std::unique_ptr<tws_launch::RecordedRequests> requests;
  if (input.is_bag)
    sources.push_back((requests = std::make_unique<tws_launch::RecordedRequests>(offline.graph(), input.path)).get());
  if (input.is_bag)
    sources.push_back((bag = std::make_unique<tws_runtime::BagSource>(offline.graph(), input.path)).get());
  const ros::Duration duration = options.duration ? ros::Duration(*options.duration) : ros::DURATION_MAX;
  tws_runtime::runOffline(offline.graph(), sources, duration, [&] {
    offline.progress().say(1.0);
    return interrupted == 0;
  });
  offline.graph().finishRecording();
  offline.progress().summary().print(std::cout, offline.graph().counters(),
                                     std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

}  // namespace

int main(int argc, char** argv) {
  return tws_runtime::guarded("tws_offline", [&] {
    Options options;
    CLI::App app("Runs the whole graph in one process, without a ROS master, as fast as it goes.", "tws_offline");
    app.add_option("input", options.input, "scenario (*.yaml), recorded run (*.bag) or ASTERIX recording")
        ->required()
        ->check(CLI::ExistingFile);
    app.add_option("--out", options.out, "folder for run.bag");
    app.add_option("--params", options.params,
                   "parameter set of the ADIT tracker: default, nrl7952 or the path of a file");
    app.add_option("--clutter-map", options.clutter_map, "clutter that the ADIT tracker knows from the start: a file")
        ->check(CLI::ExistingFile);
    app.add_option("--frame-builder", options.frame_builder,
                   "parameters of the frame builder, in place of its own file");
    app.add_option("--mfa-stub", options.mfa_stub, "parameters of the tracker of its frames, in place of its own file");
    app.add_option("--correlator", options.correlator, "parameters of the correlator, in place of its own file")
        ->check(CLI::ExistingFile);
    app.add_option("--windows", options.windows, "the radar that the window tracker tracks, too");
    app.add_option("--window-params", options.window_params, "parameters of the window tracker: the path of a file")
        ->check(CLI::ExistingFile);
    app.add_option("--range-params", options.range_params,
                   "parameter set of the range-gate tracker: aircraft, aircraft_no_background, ship or the path of a "
                   "file; default: by the name of the scenario or bag");
    app.add_option("--seed", options.seed, "of the random numbers, in place of the scenario's")->check(seedProblem);
    tws_runtime::addDuration(app, options.duration);
    if (const auto status = tws_runtime::parseCommandLine(app, argc, argv)) return *status;
    if (options.seed && (tws_launch::isBag(options.input) || tws_launch::isRecording(options.input))) {
      std::cerr << "tws_offline: --seed is for scenarios; "
                << (tws_launch::isBag(options.input) ? "a bag" : "a recording") << " has no random numbers\n";
      return 2;
    }
    std::signal(SIGINT, [](int) { interrupted = 1; });
    std::signal(SIGTERM, [](int) { interrupted = 1; });
    run(options);
    return interrupted ? 130 : 0;
  });
}
