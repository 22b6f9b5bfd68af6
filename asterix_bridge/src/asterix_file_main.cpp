#include <asterix_bridge/asterix_node.h>
#include <tws_runtime/node_main.h>

TWS_NODE(asterix_bridge, asterix_file_node, "asterix", tws_runtime::sourceProgram<asterix_bridge::AsterixFileNode>())
