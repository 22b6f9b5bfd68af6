#include <tws_runtime/run.h>

#include "example_nodes.h"

int main(int argc, char** argv) {
  return tws_runtime::runNode(argc, argv, "relay",
                              [](tws_runtime::Bus& bus) { return std::make_shared<tws_runtime::RelayNode>(bus); });
}
