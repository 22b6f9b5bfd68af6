#include <tws_runtime/run.h>

#include "example_nodes.h"

int main(int argc, char** argv) {
  return tws_runtime::runProgram(argc, argv, "numbers", tws_runtime::sourceProgram<tws_runtime::NumbersSource>());
}
