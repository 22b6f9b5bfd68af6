#include <tws_runtime/node_main.h>

#include "example_nodes.h"

TWS_NODE(tws_runtime, relay_node, "relay", tws_runtime::nodeProgram<tws_runtime::RelayNode>())
