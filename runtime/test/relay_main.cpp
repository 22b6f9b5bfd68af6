#include <tws_runtime/run.h>

#include "example_nodes.h"

int main(int argc, char** argv) {
  return tws_runtime::runProgram(argc, argv, "relay", tws_runtime::nodeProgram<tws_runtime::RelayNode>());
}
