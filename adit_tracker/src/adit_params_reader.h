#pragma once

#include <string>

#include <tws_runtime/parameters.h>
#include <yaml-cpp/yaml.h>

#include "adit_params.h"

namespace adit_tracker {

/// Reads the tracker's parameters from a tree as in config/default.yaml: the key `set` names the set that the other
/// keys change. `default_set` counts when the key is absent. Throws tws_runtime::ParameterError. The radars are not yet
/// checked: they may come from elsewhere (see check).
AditParams readAditParams(tws_runtime::ParameterReader& reader, const std::string& default_set = "default");

/// Whether AditParams::named() knows it.
bool isNamedSet(const std::string& name);

/// A named set, or the file of that path. Throws tws_runtime::ParameterError.
AditParams loadAditParams(const std::string& name_or_file);

}  // namespace adit_tracker
