#include <range_gate_tracker/range_gate_tracker_node.h>
#include <tws_runtime/node_main.h>

TWS_NODE(range_gate_tracker, range_gate_tracker_node, "range_gate_tracker",
         tws_runtime::nodeProgram<range_gate_tracker::RangeGateTrackerNode>())
