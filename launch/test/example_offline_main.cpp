#include <nearest_tracker/nearest_node.h>

#include "offline_main.h"

// tws_offline with the example tracker: what the row in node_registry.cpp does for a tracker of this repository.
int main(int argc, char** argv) {
  using namespace tws_launch;
  NodeRegistry registry = nodeRegistry();
  registry.insert(nodeRow<nearest_tracker::NearestNode>("nearest_tracker/nearest_node"));
  return offlineMain(argc, argv, registry);
}
