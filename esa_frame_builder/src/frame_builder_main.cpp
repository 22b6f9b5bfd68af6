#include <esa_frame_builder/frame_builder_node.h>
#include <tws_runtime/node_main.h>

TWS_NODE(esa_frame_builder, frame_builder_node, "frame_builder",
         tws_runtime::nodeProgram<esa_frame_builder::FrameBuilderNode>())
