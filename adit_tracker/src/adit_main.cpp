#include <adit_tracker/adit_node.h>
#include <tws_runtime/run.h>

int main(int argc, char** argv) {
  return tws_runtime::runNode(argc, argv, "adit", [](tws_runtime::Bus& bus) -> std::shared_ptr<void> {
    return std::make_shared<adit_tracker::AditNode>(bus);
  });
}
