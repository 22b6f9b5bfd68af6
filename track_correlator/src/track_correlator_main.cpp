#include <track_correlator/track_correlator_node.h>
#include <tws_runtime/run.h>

int main(int argc, char** argv) {
  return tws_runtime::runNode(argc, argv, "track_correlator", [](tws_runtime::Bus& bus) -> std::shared_ptr<void> {
    return std::make_shared<track_correlator::TrackCorrelatorNode>(bus);
  });
}
