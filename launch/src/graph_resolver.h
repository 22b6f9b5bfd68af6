#pragma once

#include "graph_description.h"
#include "graph_file.h"
#include "run_input.h"
#include "run_options.h"

namespace tws_launch {

/// The graph that follows from what is in the input, from what it says of its trackers, and from what a person says.
/// `live`: for roslaunch, with player, recorder and picture. Throws std::runtime_error, and UsageError for a choice of
/// a node that is no part of this graph.
GraphDescription resolveGraph(const GraphFile& file, const RunInput& input, const RunOptions& options, bool live);

}  // namespace tws_launch
