#include <tws_runtime/run.h>

#include "example_nodes.h"

int main(int argc, char** argv) {
  return tws_runtime::runSourceNode(
      argc, argv, "numbers", [](tws_runtime::Bus& bus) { return std::make_unique<tws_runtime::NumbersSource>(bus); });
}
