#include <track_correlator/track_correlator_node.h>
#include <tws_runtime/node_main.h>

TWS_NODE(track_correlator, track_correlator_node, "track_correlator",
         tws_runtime::nodeProgram<track_correlator::TrackCorrelatorNode>())
