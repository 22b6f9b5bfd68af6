#include <track_correlator/ssr_tracker_node.h>
#include <tws_runtime/node_main.h>

TWS_NODE(track_correlator, ssr_tracker_node, "ssr_tracker",
         tws_runtime::nodeProgram<track_correlator::SsrTrackerNode>())
