#include <tws_runtime/command_line.h>

#include <cstdlib>
#include <iostream>

#include "command_words.h"
#include "graph_resolver.h"
#include "in_words.h"
#include "run_input.h"
#include "run_plan.h"

namespace {

using namespace tws_launch;

const char* const kHelp =
    "Says what follows from a scenario, bag or ASTERIX recording.\n"
    "  tws_inspect INPUT [options]            its length, and the graph for it, as YAML\n"
    "  tws_inspect launch [INPUT] [options]   the same as a launch file for roslaunch; without input: a live feed\n"
    "  tws_inspect plan COMMAND WORDS...      for ./tws: what a command does, as assignments for the shell\n"
    "  tws_inspect check COMMAND WORDS...     whether these words can be meant\n"
    "  tws_inspect scenarios                  names of the scenarios\n"
    "Options, also as roslaunch has them (rate:=5):\n";

int describe(const std::vector<std::string>& words) {
  const CommandWords read = readCommandWords(words, {}, {}, 1);
  if (read.arguments.empty()) throw UsageError("which scenario, bag or recording?");
  const GraphFile file = readGraphFileWith(read.options["graph"]);
  const RunInput input = inspectInput(inputFile(read.arguments[0]), file, read.options);
  std::cout << "length: " << input.length << "\n" << toYaml(resolveGraph(file, input, read.options, false));
  return 0;
}

int launch(const std::vector<std::string>& words) {
  CommandWords read = readCommandWords(words, {}, {"rviz_file", "input"}, 1);
  if (!read.arguments.empty()) read.others["input"] = read.arguments[0];
  const std::string input = read.others["input"].empty() ? "" : inputFile(read.others["input"]);
  if (input.empty() && !read.options.has("udp")) throw UsageError("which scenario, bag, recording or feed?");
  const auto rviz_file = read.others.find("rviz_file");
  std::cout << launchFileFor(input, read.options, rviz_file == read.others.end() ? "" : rviz_file->second);
  return 0;
}

int plan(const std::vector<std::string>& words) {
  const char* root = std::getenv("TWS_ROOT");
  std::cout << plannedRun(words.at(0), {words.begin() + 1, words.end()}, root ? root : ".");
  return 0;
}

int runWith(const std::vector<std::string>& words) {
  const std::string first = words.empty() ? "--help" : words[0];
  const std::vector<std::string> rest(words.begin() + (words.empty() ? 0 : 1), words.end());
  if (first == "--help" || first == "-h") {
    std::cout << kHelp << explained({});
    return 0;
  }
  if (first == "scenarios") {
    std::cout << joined(scenarioNames()) << "\n";
    return 0;
  }
  if (first == "launch") return launch(rest);
  if (first == "plan" && !rest.empty()) return plan(rest);
  if (first == "check" && !rest.empty()) {
    checkWords(rest[0], {rest.begin() + 1, rest.end()});
    return 0;
  }
  return describe(words);
}

/// For ./tws, which says how it is used.
int sayUsage(const std::string& error) {
  const char* usage = std::getenv("TWS_USAGE");
  std::cerr << (usage ? "tws" : "tws_inspect") << ": " << error
            << (usage ? std::string("; expected: ") + usage : " (tws_inspect --help says more)") << "\n";
  return 2;
}

}  // namespace

int main(int argc, char** argv) {
  return tws_runtime::guarded("tws_inspect", [&] {
    try {
      return runWith({argv + 1, argv + argc});
    } catch (const UsageError& error) {
      return sayUsage(error.what());
    }
  });
}
