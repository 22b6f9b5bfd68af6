#include "run_input.h"

#include <asterix_bridge/asterix_node.h>
#include <radar_sim/radar_sim_node.h>
#include <tws_core/units.h>
#include <tws_runtime/local_graph.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#include "bag_input.h"
#include "in_words.h"
#include "topic_name.h"

namespace tws_launch {
namespace {

/// "sps12" of "sps12/detections", with or without a slash ahead.
std::string sensorOf(const std::string& topic) { return spaceOf(relativeName("", topic)); }

bool endsWith(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// The sensors of a kind: those that say its first topic.
std::vector<std::string> namesOf(const SensorKind& kind, const radar_sim::RadarSimNode& simulator) {
  const auto& [part, type] = kind.topics.front();
  std::vector<std::string> names;
  for (const radar_sim::SensorTopics& sensor : simulator.sensors())
    for (const radar_sim::SensorTopic& topic : sensor.published)
      if (topic.type == type && endsWith(topic.name, "/" + part) && kind.takes(sensorOf(topic.name)))
        names.push_back(sensorOf(topic.name));
  return names;
}

/// By the simulator itself, so that what it would refuse is refused here, before anything is started.
void readScenario(RunInput& input, const GraphFile& file, const RunOptions& options) {
  YAML::Node parameters;
  parameters["scenario"] = input.path;
  if (options.has("duration")) parameters["duration"] = options["duration"];
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  const radar_sim::RadarSimNode simulator(graph.addNode("radar_sim", parameters));
  for (const SensorKind& kind : file.sensors) input.sensors[kind.name] = kind.ordered(namesOf(kind, simulator));
  input.length = simulator.duration();
  input.origin["latitude_deg"] = tws::degrees(simulator.origin().latitude);
  input.origin["longitude_deg"] = tws::degrees(simulator.origin().longitude);
  input.origin["altitude_m"] = simulator.origin().altitude;
  input.trackers = readTrackerChoices(simulator.trackers(), std::filesystem::path(input.path).parent_path(),
                                      input.path + ": trackers");
}

// Radars of one recording seldom stand at one site, and only such may feed one tracker.
void readRecording(RunInput& input, const std::vector<std::string>& radars, bool own_names) {
  const asterix_bridge::RecordingSummary summary = asterix_bridge::inspectRecording(input.path);
  for (const std::string& radar : radars)
    if (!own_names && std::count(summary.radars.begin(), summary.radars.end(), radar) == 0)
      throw UsageError("--radars: " + input.path + " has no radar '" + radar + "' (radars: " + joined(summary.radars) +
                       ")");
  if (!summary.radars.empty()) input.sensors["rotating"] = {summary.radars.front()};
  input.length = summary.length;
}

void readAsterix(RunInput& input, const RunOptions& options) {
  std::istringstream words(options["radars"]);
  const std::vector<std::string> radars{std::istream_iterator<std::string>(words), {}};
  if (input.kind == InputKind::kRecording) readRecording(input, radars, options.has("settings"));
  if (input.kind == InputKind::kFeed) input.sensors["rotating"] = {"radar"};
  if (!radars.empty()) input.sensors["rotating"] = radars;
  input.sensors["secondary"] = input.sensors["rotating"];
}

InputKind kindOf(const std::string& path) {
  if (path.empty()) return InputKind::kFeed;
  if (isBag(path)) return InputKind::kBag;
  return isRecording(path) ? InputKind::kRecording : InputKind::kScenario;
}

void refuseRate(InputKind kind, const RunOptions& options) {
  if (kind == InputKind::kBag && std::stod(options["rate"]) <= 0.0)
    throw UsageError("--rate: a bag is played at a rate above 0");
}

void refuseSeed(InputKind kind, const RunOptions& options) {
  if (kind == InputKind::kScenario || !options.has("seed")) return;
  const std::string what = kind == InputKind::kBag ? "a bag" : "a recording";
  throw UsageError("--seed is for scenarios; " + what + " has no random numbers");
}

}  // namespace

std::vector<std::string> RunInput::names(const std::string& sensor_kind) const {
  const auto found = sensors.find(sensor_kind);
  return found == sensors.end() ? std::vector<std::string>() : found->second;
}

bool isBag(const std::string& path) {
  std::string beginning(7, '\0');
  std::ifstream(path, std::ios::binary).read(beginning.data(), 7);
  return endsWith(path, ".bag") || beginning == "#ROSBAG";
}

bool isRecording(const std::string& path) {
  return !isBag(path) && !endsWith(path, ".yaml") && !endsWith(path, ".yml");
}

void refuseOptions(const std::string& path, const RunOptions& options) {
  refuseSeed(kindOf(path), options);
  refuseRate(kindOf(path), options);
}

RunInput inspectInput(const std::string& path, const GraphFile& file, const RunOptions& options) {
  RunInput input;
  input.kind = kindOf(path);
  input.path = path.empty() ? path : std::filesystem::absolute(path).lexically_normal().string();
  refuseOptions(path, options);
  if (input.kind == InputKind::kScenario) readScenario(input, file, options);
  if (input.kind == InputKind::kBag) readBag(input, file, options["namespace"]);
  if (input.kind == InputKind::kRecording || input.kind == InputKind::kFeed) readAsterix(input, options);
  if (options.has("duration") && input.kind != InputKind::kScenario)
    input.length = std::min(input.length, std::stod(options["duration"]));
  const bool tracked = std::any_of(file.sensors.begin(), file.sensors.end(), [&](const SensorKind& kind) {
    return kind.primary && !input.names(kind.name).empty();
  });
  if (!tracked) throw std::runtime_error(input.path + ": no primary radar in it");
  return input;
}

}  // namespace tws_launch
