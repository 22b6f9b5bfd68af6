#include <radar_sim/radar_sim_node.h>
#include <tws_runtime/node_main.h>

TWS_NODE(radar_sim, radar_sim_node, "radar_sim", tws_runtime::sourceProgram<radar_sim::RadarSimNode>())
