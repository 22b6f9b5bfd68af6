#include <nearest_tracker/nearest_node.h>
#include <tws_runtime/node_main.h>

TWS_NODE(nearest_tracker, nearest_node, "nearest", tws_runtime::nodeProgram<nearest_tracker::NearestNode>())
