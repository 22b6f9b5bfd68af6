#include <tws_runtime/node_main.h>

#include <iostream>
#include <memory>

#include "progress_node.h"

TWS_NODE(tws_launch, progress_node, "progress", tws_runtime::nodeProgram([](tws_runtime::Bus& bus) {
           return std::make_shared<tws_launch::ProgressNode>(bus, std::cout);
         }))
