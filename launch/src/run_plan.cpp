#include "run_plan.h"

#include <tws_core/output_file.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <regex>
#include <sstream>
#include <stdexcept>

#include "command_words.h"
#include "graph_file.h"
#include "graph_resolver.h"
#include "in_words.h"
#include "launch_xml.h"
#include "package_folder.h"
#include "run_input.h"

namespace tws_launch {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> kRunOptions{"clutter_map",   "duration", "graph", "namespace", "nodelets", "params",
                                        "picture_range", "rate",     "rviz",  "seed",      "trackers", "show_windows"};

std::string shellWord(const std::string& text) {
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return word + "'";
}

void write(const std::string& path, const std::string& text) {
  tws::OutputFile file(path);
  file.stream() << text;
  file.finish();
}

/// Our configuration of RViz shows 200 km; another range makes another scale.
void writeRvizConfig(const std::string& path, double range) {
  constexpr double kUsualRange = 200000.0;
  const std::string usual = tws::readRegularFile(packageFolder("tws_rviz") + "/config/ppi.rviz", 1U << 20U);
  std::smatch scale;
  if (!std::regex_search(usual, scale, std::regex("\n( +Scale: )([0-9.]+)")))
    throw std::runtime_error("ppi.rviz has no scale");
  std::ostringstream changed;
  changed << "\n" << scale[1] << std::stod(scale[2]) * kUsualRange / range;
  write(path, scale.prefix().str() + changed.str() + scale.suffix().str());
}

bool hasDisplay() {
  const auto isSet = [](const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
  };
  return isSet("DISPLAY") || isSet("WAYLAND_DISPLAY");
}

std::string newFolder(const std::string& root, const std::string& input) {
  const std::time_t now = std::time(nullptr);
  char date[32];
  std::strftime(date, sizeof date, "%Y%m%d-%H%M%S", std::localtime(&now));
  return root + "/out/" + date + "-" + (isBag(input) ? "replay" : fs::path(input).stem().string());
}

/// Some minutes of a large scenario; a run that needs more is watched while it lasts.
void checkSpace(const std::string& bag) {
  constexpr std::uint64_t kLeast = 256;  // [MB]
  const std::uint64_t space = tws::spaceFor(bag) >> 20U;
  tws::checkOutputPath(bag);
  if (space < kLeast)
    throw std::runtime_error(bag + ": the disk has " + std::to_string(space) + " MB left, and a run needs " +
                             std::to_string(kLeast) + "; make room, or name another folder by --out");
}

std::string madeFolder(const CommandWords& words, const std::string& root, const std::string& input) {
  const auto out = words.others.find("out");
  std::string folder = fs::absolute(out == words.others.end() ? newFolder(root, input) : out->second).string();
  const std::string bag = folder + "/run.bag";
  if (fs::exists(bag) && fs::equivalent(bag, input))
    throw std::runtime_error(input + " is the bag itself: name another folder by --out");
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw std::runtime_error("cannot make the folder " + folder + ": " + error.message());
  checkSpace(bag);
  return folder;
}

std::string inputOf(const std::string& command, const CommandWords& words) {
  if (words.arguments.empty() && command == "replay") throw UsageError("which bag?");
  if (words.arguments.empty() && command == "offline") throw UsageError("which scenario or file?");
  std::string input = inputFile(words.arguments.empty() ? "full" : words.arguments[0]);
  if (command == "replay" && !isBag(input)) throw UsageError(input + " is not a .bag");
  return input;
}

/// RViz opens where there is a display, at rate 1; without it the run is ten times as fast.
void setUsualOptions(RunOptions& options) {
  if (!options.has("rviz")) options.set("rviz", hasDisplay() ? "true" : "false");
  if (!options.isSaid("rate")) options.set("rate", options.flag("rviz") ? "1" : "10");
  if (std::stod(options["rate"]) < 0.001) throw UsageError("--rate wants a number from 0.001 to 1000000");
}

std::string planLive(const CommandWords& words, const std::string& input, const std::string& root) {
  RunOptions options = words.options;
  setUsualOptions(options);
  launchFileFor(input, options, "");  // What is wrong is said before there is a folder.
  const std::string folder = madeFolder(words, root, input);
  options.set("record", folder + "/run.bag");
  const std::string launch = folder + "/graph.launch";
  write(launch, launchFileFor(input, options, folder + "/ppi.rviz"));
  return "folder=" + shellWord(folder) + "\nlaunch=" + shellWord(launch) + "\n";
}

std::string planOffline(const CommandWords& words, const std::string& input, const std::string& root) {
  const GraphFile file = readGraphFileWith(words.options["graph"]);
  resolveGraph(file, inspectInput(input, file, words.options), words.options, false);
  const std::string folder = madeFolder(words, root, input);
  std::string told = shellWord(input) + " --out " + shellWord(folder);
  for (const auto& [name, value] : words.options.said()) told += " --" + name + " " + shellWord(value);
  return "folder=" + shellWord(folder) + "\nwords=(" + told + ")\n";
}

}  // namespace

namespace {

CommandWords readWords(const std::string& command, const std::vector<std::string>& words) {
  std::set<std::string> allowed = kRunOptions;
  if (command == "replay") allowed.erase("seed");
  if (command == "offline")
    for (const char* name : {"nodelets", "rate", "rviz", "picture_range", "show_windows"}) allowed.erase(name);
  return readCommandWords(words, allowed, {"out"}, 1);
}

}  // namespace

void checkWords(const std::string& command, const std::vector<std::string>& words) {
  const CommandWords read = readWords(command, words);
  const std::string input = inputOf(command, read);
  RunOptions options = read.options;
  if (command != "offline") setUsualOptions(options);
  refuseOptions(input, options);
}

std::string plannedRun(const std::string& command, const std::vector<std::string>& words, const std::string& root) {
  const CommandWords read = readWords(command, words);
  const std::string input = inputOf(command, read);
  return command == "offline" ? planOffline(read, input, root) : planLive(read, input, root);
}

std::vector<std::string> scenarioNames() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(packageFolder("tws_launch") + "/scenarios"))
    if (entry.path().extension() == ".yaml") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

std::string inputFile(const std::string& name) {
  for (const std::string& path : {name, packageFolder("tws_launch") + "/scenarios/" + name + ".yaml"})
    if (fs::is_regular_file(path)) return fs::canonical(path).string();
  throw UsageError("no file or scenario '" + name + "' (scenarios: " + joined(scenarioNames()) + ")");
}

std::string launchFileFor(const std::string& input, RunOptions options, const std::string& rviz_config) {
  const GraphFile file = readGraphFileWith(options["graph"]);
  const RunInput read = inspectInput(input, file, options);
  if (options.has("record")) tws::checkOutputPath(options["record"], {input});
  if (!rviz_config.empty() && options.flag("rviz") && options.isSaid("picture_range") && !options.has("rviz_config")) {
    writeRvizConfig(rviz_config, std::stod(options["picture_range"]));
    options.set("rviz_config", rviz_config);
  }
  return launchXml(resolveGraph(file, read, options, true));
}

}  // namespace tws_launch
