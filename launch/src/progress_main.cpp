#include <tws_runtime/run.h>

#include <iostream>

#include "progress_node.h"

int main(int argc, char** argv) {
  return tws_runtime::runNode(argc, argv, "progress", [](tws_runtime::Bus& bus) {
    return std::make_shared<tws_launch::ProgressNode>(bus, std::cout);
  });
}
