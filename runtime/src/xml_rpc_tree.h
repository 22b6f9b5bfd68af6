#pragma once

#include <XmlRpcValue.h>
#include <yaml-cpp/yaml.h>

#include <string>

namespace tws_runtime {

/// The parameter server's value as a tree. Numbers keep every bit. Throws ParameterError about `where` for a date or
/// binary data.
YAML::Node treeFromXmlRpc(XmlRpc::XmlRpcValue value, const std::string& where);

}  // namespace tws_runtime
