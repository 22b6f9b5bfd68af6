#pragma once

#include <tws_runtime/bus.h>
#include <tws_runtime/source.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <variant>

namespace tws_launch {

using NodeMaker = std::function<std::shared_ptr<void>(tws_runtime::Bus& bus)>;
using SourceMaker = std::function<std::unique_ptr<tws_runtime::Source>(tws_runtime::Bus& bus)>;

/// Makes the nodes of programs, by PACKAGE/PROGRAM, in one process.
using NodeRegistry = std::map<std::string, std::variant<NodeMaker, SourceMaker>>;

/// Those of this repository. What is not in it runs only live.
const NodeRegistry& nodeRegistry();

/// A row of the registry.
template <class Node>
NodeRegistry::value_type nodeRow(const std::string& program) {
  return {program, NodeMaker([](tws_runtime::Bus& bus) { return std::make_shared<Node>(bus); })};
}
template <class Source>
NodeRegistry::value_type sourceRow(const std::string& program) {
  return {program, SourceMaker([](tws_runtime::Bus& bus) { return std::make_unique<Source>(bus); })};
}

}  // namespace tws_launch
