#include <track_evaluation/evaluation_node.h>
#include <tws_runtime/node_main.h>

TWS_NODE(track_evaluation, evaluation_node, "evaluation", tws_runtime::nodeProgram<track_evaluation::EvaluationNode>())
