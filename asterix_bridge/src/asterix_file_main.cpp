#include <asterix_bridge/asterix_node.h>
#include <tws_runtime/run.h>

int main(int argc, char** argv) {
  return tws_runtime::runSourceNode(argc, argv, "asterix", [](tws_runtime::Bus& bus) {
    return std::make_unique<asterix_bridge::AsterixFileNode>(bus);
  });
}
