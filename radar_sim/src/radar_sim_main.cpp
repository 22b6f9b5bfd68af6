#include <radar_sim/radar_sim_node.h>
#include <tws_runtime/run.h>

int main(int argc, char** argv) {
  return tws_runtime::runSourceNode(
      argc, argv, "radar_sim", [](tws_runtime::Bus& bus) { return std::make_unique<radar_sim::RadarSimNode>(bus); });
}
