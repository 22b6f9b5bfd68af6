#pragma once

#include <tws_runtime/parameters.h>
#include <yaml-cpp/yaml.h>

#include <string>
#include <vector>

#include "requirements.h"

namespace track_evaluation {

/// The profiles in the list `profiles` of a node's parameters. Throws tws_runtime::ParameterError.
std::vector<RequirementProfile> readProfiles(tws_runtime::ParameterReader& reader);
/// The profiles in a tree like config/requirements.yaml. Throws tws_runtime::ParameterError.
std::vector<RequirementProfile> readRequirements(const YAML::Node& tree, const std::string& where);

}  // namespace track_evaluation
