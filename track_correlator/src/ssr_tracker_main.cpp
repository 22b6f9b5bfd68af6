#include <track_correlator/ssr_tracker_node.h>
#include <tws_runtime/run.h>

int main(int argc, char** argv) {
  return tws_runtime::runNode(argc, argv, "ssr_tracker", [](tws_runtime::Bus& bus) -> std::shared_ptr<void> {
    return std::make_shared<track_correlator::SsrTrackerNode>(bus);
  });
}
