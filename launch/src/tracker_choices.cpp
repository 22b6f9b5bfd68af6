#include "tracker_choices.h"

#include <tws_runtime/parameters.h>

#include <filesystem>
#include <stdexcept>

namespace tws_launch {
namespace {

std::string inFolder(const std::string& set, const std::string& folder) {
  return isPath(set) ? (std::filesystem::path(folder) / set).lexically_normal().string() : set;
}

/// YAML 1.2 knows no on and off.
std::optional<bool> onOrOff(const YAML::Node& node) {
  bool on = false;
  if (!node.IsScalar() || node.Tag() == "!" || !YAML::convert<bool>::decode(node, on)) return std::nullopt;
  return on;
}

TrackerChoice readChoice(const YAML::Node& node, const std::string& folder, const std::string& where) {
  TrackerChoice choice;
  choice.on = onOrOff(node);
  if (choice.on) return choice;
  choice.on = true;
  if (node.IsScalar()) {
    choice.set = inFolder(node.Scalar(), folder);
  } else if (node.IsMap()) {
    choice.parameters = YAML::Clone(node);
    for (auto [key, value] : {std::pair{"params", &choice.set}, {"like", &choice.like}}) {
      if (!choice.parameters[key]) continue;
      if (!choice.parameters[key].IsScalar()) throw std::runtime_error(where + "/" + key + ": is no name");
      *value = choice.parameters[key].Scalar();
      choice.parameters.remove(key);
    }
    choice.set = inFolder(choice.set, folder);
  } else {
    throw std::runtime_error(where + ": expected a parameter set, on, off, or a map of parameters");
  }
  return choice;
}

}  // namespace

TrackerChoices readTrackerChoices(const YAML::Node& tree, const std::string& folder, const std::string& where) {
  TrackerChoices choices;
  if (!tree || tree.IsNull()) return choices;
  if (!tree.IsMap()) throw std::runtime_error(where + ": expected a map, of which each key is a node's name");
  for (const auto& entry : tree) {
    const std::string name = entry.first.as<std::string>();
    choices[name] = readChoice(entry.second, folder, where + "/" + name);
  }
  return choices;
}

TrackerChoices merged(TrackerChoices choices, const TrackerChoices& later) {
  for (const auto& [name, choice] : later) {
    TrackerChoice& result = choices[name];
    if (choice.on) result.on = choice.on;
    if (!choice.like.empty()) result.like = choice.like;
    if (!choice.set.empty()) result.set = choice.set;
    if (choice.parameters.IsMap())
      result.parameters = tws_runtime::mergeParameters(result.parameters, choice.parameters);
  }
  return choices;
}

bool isPath(const std::string& set) {
  const std::string extension = std::filesystem::path(set).extension();
  return set.find('/') != std::string::npos || extension == ".yaml" || extension == ".yml";
}

}  // namespace tws_launch
