#include <tws_runtime/node_main.h>
#include <tws_rviz/sine_space_node.h>

TWS_NODE(tws_rviz, sine_space_node, "sine_space", tws_runtime::nodeProgram<tws_rviz::SineSpaceNode>())
