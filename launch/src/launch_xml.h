#pragma once

#include <string>

#include "graph_description.h"

namespace tws_launch {

/// The graph as a launch file for roslaunch.
std::string launchXml(const GraphDescription& graph);

}  // namespace tws_launch
