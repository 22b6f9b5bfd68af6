#include "node_parameters.h"

#include <tws_runtime/parameters.h>

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "in_words.h"
#include "package_folder.h"

namespace tws_launch {
namespace {

namespace fs = std::filesystem;
using tws_runtime::mergeParameters;

std::vector<std::string> setsOf(const std::string& package) {
  std::vector<std::string> sets;
  for (const auto& entry : fs::directory_iterator(packageFolder(package) + "/config"))
    if (entry.path().extension() == ".yaml") sets.push_back(entry.path().stem().string());
  std::sort(sets.begin(), sets.end());
  return sets;
}

/// The file of a set, which is named by its path or as it is called in the package's config.
std::string setFile(const NodeRow& row, const std::string& name, const std::string& set,
                    const ParameterSources& sources) {
  if (isPath(set)) return set;
  std::string file = packageFolder(row.package()) + "/config/" + set + ".yaml";
  if (fs::is_regular_file(file)) return file;
  const std::string reason =
      ": there is no parameter set '" + set + "' (" + row.package() + "/config: " + joined(setsOf(row.package())) + ")";
  const auto said = sources.options.choices().find(name);
  if (said != sources.options.choices().end() && said->second.set == set) throw UsageError(name + reason);
  throw std::runtime_error(sources.input.path + ": trackers: " + name + reason);
}

std::string chosenSet(const std::string& name, const TrackerChoices& chosen) {
  const auto choice = chosen.find(name);
  return choice == chosen.end() ? "" : choice->second.set;
}

/// A set takes the place of the first file.
YAML::Node filesOf(const NodeRow& row, const std::string& name, const ParameterSources& sources,
                   const TemplateWords& words) {
  YAML::Node tree(YAML::NodeType::Map);
  std::vector<std::string> files;
  if (row["files"])
    for (const YAML::Node& file : filledIn(row["files"], words)) files.push_back(file.Scalar());
  const std::string set = chosenSet(name, sources.chosen);
  if (!set.empty() && files.empty()) files.emplace_back();
  if (!set.empty()) files.front() = setFile(row, name, set, sources);
  for (const std::string& file : files) tree = mergeParameters(tree, tws_runtime::loadParameterFile(filePath(file)));
  return tree;
}

void checkClutterMap(YAML::Node& tree, const std::string& input) {
  const std::string map = tree["clutter_map"].as<std::string>();
  if (map == "none") {
    tree.remove("clutter_map");
  } else if (!map.empty() && !fs::exists(map)) {
    throw std::runtime_error(input + ": the run knew the clutter of " + map +
                             " from its start, which is not there: say --clutter-map FILE or --clutter-map none");
  }
}

}  // namespace

YAML::Node nodeParameters(const NodeRow& row, const std::string& name, const ParameterSources& sources,
                          const TemplateWords& words) {
  const RunInput& input = sources.input;
  const NodeDescription* then = row.role == "tracker" && input.recorded ? input.recorded->find(name) : nullptr;
  const bool anew = !then || !chosenSet(name, sources.chosen).empty();
  YAML::Node tree(YAML::NodeType::Map);
  if (anew) tree = mergeParameters(joinedParameters(row["beneath"], words), filesOf(row, name, sources, words));
  if (!anew) tree = YAML::Clone(then->parameters);
  if (anew || input.recorded->sensors != input.sensors)
    tree = mergeParameters(tree, joinedParameters(row["parameters"], words));
  tree = mergeParameters(tree, joinedParameters(row["run"], words));
  const auto choice = sources.chosen.find(name);
  if (choice != sources.chosen.end() && choice->second.parameters.IsMap())
    tree = mergeParameters(tree, choice->second.parameters);
  if (tree["clutter_map"]) checkClutterMap(tree, input.path);
  return tree;
}

std::string filePath(const std::string& file) {
  if (file[0] == '/') return file;
  const auto slash = file.find('/');
  return packageFolder(file.substr(0, slash)) + file.substr(slash);
}

}  // namespace tws_launch
