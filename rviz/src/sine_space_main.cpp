#include <tws_runtime/run.h>
#include <tws_rviz/sine_space_node.h>

int main(int argc, char** argv) {
  return tws_runtime::runNode(argc, argv, "sine_space",
                              [](tws_runtime::Bus& bus) { return std::make_shared<tws_rviz::SineSpaceNode>(bus); });
}
