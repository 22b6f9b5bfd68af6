#include <iostream>

#include "run_input.h"

// For ./tws: what the launch files want to be told of a scenario or bag, as roslaunch arguments, one a line.
int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: tws_inspect SCENARIO.yaml|RUN.bag" << std::endl;
    return 2;
  }
  try {
    const tws_launch::RunInput input = tws_launch::inspectInput(argv[1]);
    std::cout << "radars:=";
    for (std::size_t i = 0; i < input.radars.size(); ++i) std::cout << (i ? " " : "") << input.radars[i];
    std::cout << "\nlength:=" << input.length << std::endl;
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "tws_inspect: " << error.what() << std::endl;
    return 1;
  }
}
