#include <range_gate_tracker/window_tracker_node.h>
#include <tws_runtime/run.h>

int main(int argc, char** argv) {
  return tws_runtime::runNode(argc, argv, "window_tracker", [](tws_runtime::Bus& bus) -> std::shared_ptr<void> {
    return std::make_shared<range_gate_tracker::WindowTrackerNode>(bus);
  });
}
