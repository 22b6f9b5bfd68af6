#include <esa_frame_builder/mfa_stub_node.h>
#include <tws_runtime/node_main.h>

TWS_NODE(esa_frame_builder, mfa_stub_node, "mfa_stub", tws_runtime::nodeProgram<esa_frame_builder::MfaStubNode>())
