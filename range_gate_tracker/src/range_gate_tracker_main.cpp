#include <range_gate_tracker/range_gate_tracker_node.h>
#include <tws_runtime/run.h>

int main(int argc, char** argv) {
  return tws_runtime::runNode(argc, argv, "range_gate_tracker", [](tws_runtime::Bus& bus) -> std::shared_ptr<void> {
    return std::make_shared<range_gate_tracker::RangeGateTrackerNode>(bus);
  });
}
