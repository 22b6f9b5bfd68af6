#include <tws_runtime/run.h>
#include <tws_rviz/ppi_node.h>

int main(int argc, char** argv) {
  return tws_runtime::runNode(argc, argv, "ppi",
                              [](tws_runtime::Bus& bus) { return std::make_shared<tws_rviz::PpiNode>(bus); });
}
