#pragma once

#include "graph_file.h"
#include "run_input.h"

namespace tws_launch {

/// Reads what is in a bag: its sensors by the types of its topics and the radars' names in their messages, wherever the
/// topics stand, and the graph that it was recorded with. `space`: only what stands in that namespace, if anything
/// does; empty: all. Throws std::runtime_error when it cannot be read or not be understood.
void readBag(RunInput& input, const GraphFile& file, const std::string& space);

}  // namespace tws_launch
