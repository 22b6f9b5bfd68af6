#include "offline_main.h"

#include <tws_core/output_file.h>
#include <tws_runtime/bag_source.h>
#include <tws_runtime/command_line.h>
#include <tws_runtime/run.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <iostream>

#include "command_words.h"
#include "graph_resolver.h"
#include "offline_graph.h"
#include "recorded_requests.h"
#include "run_input.h"

namespace tws_launch {
namespace {

volatile std::sig_atomic_t interrupted = 0;

const std::set<std::string> kAllowed{"clutter_map", "date",   "duration", "graph",    "namespace",
                                     "params",      "radars", "seed",     "settings", "trackers"};

std::string outputFile(const std::string& folder, const RunInput& input) {
  std::filesystem::create_directories(folder);
  std::string output = folder + "/run.bag";
  tws::checkOutputPath(output, {input.path});
  return output;
}

/// What a bag brings along: what operators asked, ahead of all, and its messages.
std::vector<std::unique_ptr<tws_runtime::Source>> bagSources(OfflineGraph& offline, const RunInput& input,
                                                             const GraphDescription& graph) {
  std::vector<std::unique_ptr<tws_runtime::Source>> sources;
  if (input.kind != InputKind::kBag) return sources;
  for (const NodeDescription& node : graph.nodes)
    if (repeatsRequests(node))
      sources.push_back(std::make_unique<RecordedRequests>(offline.graph(), input, graph.space, node.name));
  sources.push_back(std::make_unique<tws_runtime::BagSource>(offline.graph(), input.path));
  return sources;
}

/// What programs want to know of the run, as JSON.
void writeTimes(const std::string& path, double simulated, double wall) {
  tws::OutputFile file(path);
  file.stream() << "{\"simulated_time_s\": " << simulated << ", \"wall_time_s\": " << wall << "}\n";
  file.finish();
}

void run(const std::string& path, const std::string& folder, const std::string& json, const RunOptions& options,
         const NodeRegistry& registry) {
  const auto start = std::chrono::steady_clock::now();
  const GraphFile file = readGraphFileWith(options["graph"]);
  const RunInput input = inspectInput(path, file, options);
  const GraphDescription graph = resolveGraph(file, input, options, false);
  OfflineGraph offline(graph, std::cerr, registry);
  offline.graph().record(outputFile(folder, input));
  std::vector<tws_runtime::Source*> sources = offline.sources();
  const auto of_bag = bagSources(offline, input, graph);
  for (const auto& source : of_bag) sources.push_back(source.get());
  const bool limited = options.has("duration");
  const ros::Duration duration = limited ? ros::Duration(std::stod(options["duration"])) : ros::DURATION_MAX;
  tws_runtime::runOffline(offline.graph(), sources, duration, [&] {
    offline.progress().say(1.0);
    return interrupted == 0;
  });
  offline.graph().finishRecording();
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const RunSummary& summary = offline.progress().summary();
  summary.print(std::cout, offline.graph().counters(), wall);
  if (!json.empty()) writeTimes(json, summary.simulatedTime(), wall);
  const std::string failure = summary.failure();
  if (!failure.empty() && interrupted == 0) throw std::runtime_error(path + ": " + failure);
}

int help() {
  std::cout << "Runs the whole graph in one process, without a ROS master, as fast as it goes:\n"
               "tws_offline SCENARIO.yaml|BAG|RECORDING [--out DIR] [options]\n"
               "  --out              folder for run.bag; default: here\n"
               "  --json             write how long it took into this file\n"
            << explained(kAllowed);
  return 0;
}

int runWith(const std::vector<std::string>& words, const NodeRegistry& registry) try {
  if (words.size() == 1 && (words[0] == "--help" || words[0] == "-h")) return help();
  CommandWords read = readCommandWords(words, kAllowed, {"out", "json"}, 1);
  if (read.arguments.empty()) throw UsageError("which scenario, bag or recording?");
  if (!std::filesystem::is_regular_file(read.arguments[0])) throw UsageError("no file '" + read.arguments[0] + "'");
  const std::string folder = read.others.count("out") > 0 ? read.others["out"] : ".";
  run(read.arguments[0], folder, read.others["json"], read.options, registry);
  return interrupted ? 130 : 0;
} catch (const UsageError& error) {
  std::cerr << "tws_offline: " << error.what() << " (tws_offline --help says more)\n";
  return 2;
}

}  // namespace

int offlineMain(int argc, char** argv, const NodeRegistry& registry) {
  std::signal(SIGINT, [](int) { interrupted = 1; });
  std::signal(SIGTERM, [](int) { interrupted = 1; });
  return tws_runtime::guarded("tws_offline", [&] { return runWith({argv + 1, argv + argc}, registry); });
}

}  // namespace tws_launch
