#include <tws_runtime/node_main.h>
#include <tws_rviz/ppi_node.h>

TWS_NODE(tws_rviz, ppi_node, "ppi", tws_runtime::nodeProgram<tws_rviz::PpiNode>())
