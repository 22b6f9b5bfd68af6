#include "run_options.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <sstream>

namespace tws_launch {
namespace {

using Type = RunOption::Type;

std::string withUnderscores(std::string name) {
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

const RunOption& find(const std::string& name) {
  const auto& all = runOptions();
  const auto found = std::find_if(all.begin(), all.end(), [&](const RunOption& option) { return option.name == name; });
  if (found == all.end()) throw UsageError("unknown option --" + name);
  return *found;
}

std::string dashed(std::string name) {
  std::replace(name.begin(), name.end(), '_', '-');
  return "--" + name;
}

/// A number without exponent, as it was meant.
std::string inWords(double number) {
  std::ostringstream text;
  text << std::fixed;
  text.precision(number == std::floor(number) ? 0 : 3);
  text << number;
  return text.str();
}

void checkNumber(const RunOption& option, const std::string& text) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  const bool plain = text.find_first_not_of("0123456789.+-eE") == std::string::npos && *end == '\0';
  if (!plain || !(number >= option.least && number <= option.greatest))
    throw UsageError(dashed(option.name) + " wants a number from " + inWords(option.least) + " to " +
                     inWords(option.greatest) + ", not '" + text + "'");
}

void checkWhole(const RunOption& option, const std::string& text) {
  if (text.size() > 18 || text.find_first_not_of("0123456789") != std::string::npos)
    throw UsageError(dashed(option.name) + " wants a whole number from 0, not '" + text + "'");
}

std::string checked(const RunOption& option, const std::string& value) {
  if (option.type == Type::kNumber) checkNumber(option, value);
  if (option.type == Type::kWhole) checkWhole(option, value);
  if (option.type == Type::kFlag && value != "true" && value != "false")
    throw UsageError(dashed(option.name) + " wants true or false, not '" + value + "'");
  if (option.type != Type::kFile || value == "none") return value;
  if (!std::filesystem::is_regular_file(value)) throw UsageError(dashed(option.name) + ": no file '" + value + "'");
  return std::filesystem::absolute(value).string();
}

}  // namespace

const std::vector<RunOption>& runOptions() {
  static const std::vector<RunOption> kOptions{
      {"rate", Type::kNumber, 0.0, 1e6, "data time over wall time; 0: as fast as possible"},
      {"duration", Type::kNumber, 1.0, 1e6, "stop after so much data time [s]; default: all of it"},
      {"seed", Type::kWhole, 0, 0, "of a scenario's random numbers; default: the scenario's own"},
      {"params", Type::kText, 0, 0,
       "parameters of the ADIT tracker: a name in its config, or a file; NODE=NAME or NODE=FILE: of another node"},
      {"trackers", Type::kText, 0, 0, "what a scenario's key `trackers` says, in YAML; goes before that"},
      {"clutter_map", Type::kFile, 0, 0,
       "clutter that the ADIT tracker knows from the start: a file; none: no clutter"},
      {"respawn", Type::kFlag, 0, 0, "start the ADIT tracker again when it dies; false: end the run"},
      {"graph", Type::kFile, 0, 0, "further nodes: a file of rows like those of graph.yaml"},
      {"nodelets", Type::kFlag, 0, 0, "run the nodes as nodelets of one manager"},
      {"rviz", Type::kFlag, 0, 0, "show the PPI"},
      {"show_windows", Type::kFlag, 0, 0, "draw the window tracker's tracks, too, as triangles"},
      {"picture_range", Type::kNumber, 1000.0, 2e6, "radius of the PPI [m]"},
      {"rviz_config", Type::kFile, 0, 0, "for RViz, in place of our own"},
      {"record", Type::kText, 0, 0, "bag to record"},
      {"namespace", Type::kText, 0, 0, "of the graph; default: that of the bag's topics"},
      {"radars", Type::kText, 0, 0, "of ASTERIX: the radars to track, between spaces; default: the busiest one"},
      {"settings", Type::kFile, 0, 0, "of ASTERIX: sites, names and all other parameters"},
      {"date", Type::kText, 0, 0, "of an ASTERIX recording's first record, YYYY-MM-DD (UTC); default: found"},
      {"udp", Type::kText, 0, 0, "live ASTERIX feed: [ADDRESS:]PORT[@INTERFACE], several between spaces"},
  };
  return kOptions;
}

void RunOptions::set(const std::string& said_name, const std::string& value) {
  const RunOption& option = find(withUnderscores(said_name));
  if (value.empty()) return;
  values_[option.name] = checked(option, value);
  said_.emplace_back(option.name, values_[option.name]);
  if (option.name == "params") choose(value);
  if (option.name == "record") values_["record"] = std::filesystem::absolute(value).string();
  if (option.name == "trackers") try {
      choices_ = merged(choices_, readTrackerChoices(YAML::Load(value), std::filesystem::current_path(), "--trackers"));
    } catch (const std::exception& error) {
      throw UsageError(std::string("--trackers: ") + error.what());
    }
}

std::string RunOptions::operator[](const std::string& name) const {
  static const std::map<std::string, std::string> kDefaults{{"rate", "1"}, {"picture_range", "200000"}};
  if (const auto found = values_.find(name); found != values_.end()) return found->second;
  const auto usual = kDefaults.find(name);
  return usual == kDefaults.end() ? "" : usual->second;
}

void RunOptions::choose(const std::string& params) {
  const auto equals = params.find('=');
  TrackerChoice choice;
  choice.on = true;
  choice.set = equals == std::string::npos ? params : params.substr(equals + 1);
  if (isPath(choice.set)) {
    if (!std::filesystem::is_regular_file(choice.set)) throw UsageError("--params: no file '" + choice.set + "'");
    choice.set = std::filesystem::absolute(choice.set).string();
  }
  choices_ = merged(choices_, {{equals == std::string::npos ? "adit" : params.substr(0, equals), choice}});
}

}  // namespace tws_launch
