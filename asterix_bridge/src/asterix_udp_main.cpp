#include <asterix_bridge/asterix_node.h>
#include <tws_runtime/node_main.h>

TWS_NODE(asterix_bridge, asterix_udp_node, "asterix", tws_runtime::feedProgram<asterix_bridge::AsterixUdpNode>())
