#include <adit_tracker/adit_node.h>
#include <tws_runtime/node_main.h>

TWS_NODE(adit_tracker, adit_node, "adit", tws_runtime::nodeProgram<adit_tracker::AditNode>())
