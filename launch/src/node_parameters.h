#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

#include "graph_file.h"
#include "run_input.h"
#include "run_options.h"
#include "template.h"

namespace tws_launch {

/// What a node's parameters follow from, besides its row.
struct ParameterSources {
  const RunInput& input;
  const RunOptions& options;
  const TrackerChoices& chosen;  ///< By the input and by a person.
};

/// The parameters of the node of that name, of several layers: what stands beneath the files, the files, what follows
/// from the sensors; in their place what was recorded, as far as the sensors are those of then; above all what this run
/// is, and what was chosen. Throws UsageError when a person chose a set that is not there, else std::runtime_error.
YAML::Node nodeParameters(const NodeRow& row, const std::string& name, const ParameterSources& sources,
                          const TemplateWords& words);

/// The path of a file that is named by an absolute path, or as PACKAGE/REST.
std::string filePath(const std::string& file);

}  // namespace tws_launch
