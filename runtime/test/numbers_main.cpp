#include <tws_runtime/node_main.h>

#include "example_nodes.h"

TWS_NODE(tws_runtime, numbers_node, "numbers", tws_runtime::sourceProgram<tws_runtime::NumbersSource>())
