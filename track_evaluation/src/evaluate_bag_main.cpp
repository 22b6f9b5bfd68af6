#include <ros/package.h>
#include <track_evaluation/evaluation_node.h>
#include <tws_runtime/bag_source.h>
#include <tws_runtime/command_line.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/run.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>

#include "bag_contents.h"
#include "registration_table.h"
#include "result_file.h"

namespace {

using namespace track_evaluation;

struct BagOptions {
  std::string bag, json, series, picture, registration;
  std::string config, requirements;
  std::vector<std::string> trackers;
  bool truth_optional = false, quiet = false;
};

/// The folder that holds this package's config, in the source or the install space.
std::string packagePath() {
  std::string path = ros::package::getPath("track_evaluation");
  if (path.empty())
    throw std::runtime_error("package track_evaluation is not found: source setup.bash, or name the files");
  return path;
}

YAML::Node parametersFor(const BagOptions& options, const BagContents& contents) {
  const std::string config = options.config.empty() ? packagePath() + "/config/evaluation.yaml" : options.config;
  const std::string limits =
      options.requirements.empty() ? packagePath() + "/config/requirements.yaml" : options.requirements;
  YAML::Node found;
  found["trackers"] = contents.trackers;
  found["correlators"] = contents.correlators;
  found["radars"] = contents.radars;
  found["secondary_radars"] = contents.secondary_radars;
  found["array_radars"] = contents.array_radars;
  if (contents.origin.IsDefined() && contents.origin.IsMap()) found["origin"] = contents.origin;
  const YAML::Node files =
      tws_runtime::mergeParameters(tws_runtime::loadParameterFile(config), tws_runtime::loadParameterFile(limits));
  return tws_runtime::mergeParameters(files, found);
}

void check(const BagOptions& options, const BagContents& contents, const EvaluationNode& node) {
  if (node.epochs() > 0 || node.identifiedPlots() > 0 || options.truth_optional) return;
  if (!contents.truth.empty()) throw std::runtime_error(options.bag + ": no truth in it can be used");
  throw std::runtime_error(options.bag +
                           ": holds neither truth nor plots with identities (tws_msgs/SsrPlots) to score by");
}

/// Of the correlators those that are named, too; what else is named must be a tracker.
void choose(const std::vector<std::string>& names, BagContents& contents) {
  const std::vector<std::string> known = std::move(contents.correlators);
  contents.trackers.clear();
  contents.correlators.clear();
  for (const std::string& name : names) {
    const bool correlates = std::find(known.begin(), known.end(), name) != known.end();
    (correlates ? contents.correlators : contents.trackers).push_back(name);
  }
}

void scoreRun(const BagOptions& options) {
  BagContents contents = inspectBag(options.bag);
  if (!options.trackers.empty()) choose(options.trackers, contents);
  tws_runtime::LocalGraph graph(std::cerr);
  const std::string name = contents.space.empty() ? "evaluation" : contents.space.substr(1) + "/evaluation";
  EvaluationNode node(graph.addNode(name, parametersFor(options, contents), contents.remaps()));
  ResultFile json(options.json, {options.bag}), series(options.series, {options.bag}),
      picture(options.picture, {options.bag}), registration(options.registration, {options.bag});
  if (series) node.writeSeries(series.stream());
  if (picture) node.writePicture(picture.stream(), 2.0);
  tws_runtime::BagSource source(graph, options.bag, contents.topics());
  tws_runtime::runOffline(graph, {&source});
  node.finish();
  check(options, contents, node);
  if (json) node.writeJson(json.stream(), options.bag);
  if (registration) writeRegistrationTable(options.bag, registration.stream());
  for (ResultFile* file : {&json, &series, &picture, &registration}) file->finish();
  if (!options.quiet) node.writeTable(std::cout);
}

void addBagOptions(CLI::App& app, BagOptions& options) {
  app.add_option("bag", options.bag, "a recorded run")->required();
  app.add_option("--json", options.json, "write the metrics into this file");
  app.add_option("--series", options.series, "write the metrics of each epoch into this CSV file");
  app.add_option("--picture", options.picture, "write where truths and tracks are into this CSV file");
  app.add_option("--registration", options.registration,
                 "write what trackers said of their radars' errors of registration into this CSV file");
  app.add_option("--tracker", options.trackers, "evaluate this tracker only; several times for several");
  app.add_option("--config", options.config, "parameters in place of config/evaluation.yaml");
  app.add_option("--requirements", options.requirements, "limits in place of config/requirements.yaml");
  app.add_flag("--truth-optional", options.truth_optional, "a bag without truth is no error: timing only");
  app.add_flag("--quiet", options.quiet, "no table");
}

}  // namespace

int main(int argc, char** argv) {
  return tws_runtime::guarded("evaluate_bag", [&] {
    BagOptions options;
    CLI::App app("Scores the trackers in a recorded run.", "evaluate_bag");
    addBagOptions(app, options);
    if (const auto status = tws_runtime::parseCommandLine(app, argc, argv)) return *status;
    scoreRun(options);
    return 0;
  });
}
