#include <range_gate_tracker/window_tracker_node.h>
#include <tws_runtime/node_main.h>

TWS_NODE(range_gate_tracker, window_tracker_node, "window_tracker",
         tws_runtime::nodeProgram<range_gate_tracker::WindowTrackerNode>())
