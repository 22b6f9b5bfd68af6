#include "correlator_params_reader.h"

namespace track_correlator {

CorrelatorParams readCorrelatorParams(tws_runtime::ParameterReader& reader) {
  CorrelatorParams params;
  reader.integer("delay_sectors", params.delay_sectors, 2, 32);
  reader.number("gate", params.gate, 0.1, 1000.0);
  reader.number("position_bias_m", params.position_bias, 0.0, 1e5);
  reader.number("velocity_bias_mps", params.velocity_bias, 0.0, 1e4);
  std::string scheme = "parallel_counter";
  reader.choice("scheme", scheme, {"parallel_counter", "plain", "distance"});
  params.fusion.scheme = scheme == "plain"      ? Scheme::kPlain
                         : scheme == "distance" ? Scheme::kDistance
                                                : Scheme::kParallelCounter;
  reader.integer("initiate_above", params.fusion.initiate_above, 0, 100);
  reader.integer("clear_scans", params.fusion.clear_scans, 1, 1000);
  reader.integer("parallel_scans", params.fusion.parallel_scans, 1, 100);
  reader.number("release_distance_m", params.release_distance, 0.0, 1e6);
  reader.integer("release_scans", params.release_scans, 1, 1000);
  reader.number("track_timeout_s", params.track_timeout, 0.1, 3600.0);
  return params;
}

}  // namespace track_correlator
