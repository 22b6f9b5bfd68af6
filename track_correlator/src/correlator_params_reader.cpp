#include "correlator_params_reader.h"

namespace track_correlator {
namespace {

using tws_runtime::ParameterReader;

void count(ParameterReader& reader, const std::string& key, int& value, long least, long greatest) {
  long number = value;
  reader.integer(key, number, least, greatest);
  value = static_cast<int>(number);
}

}  // namespace

CorrelatorParams readCorrelatorParams(ParameterReader& reader) {
  CorrelatorParams params;
  count(reader, "delay_sectors", params.delay_sectors, 2, 32);
  reader.number("gate", params.gate, 0.1, 1000.0);
  reader.number("position_bias_m", params.position_bias, 0.0, 1e5);
  reader.number("velocity_bias_mps", params.velocity_bias, 0.0, 1e4);
  std::string scheme = "parallel_counter";
  reader.choice("scheme", scheme, {"parallel_counter", "plain", "distance"});
  params.fusion.scheme = scheme == "plain"      ? Scheme::kPlain
                         : scheme == "distance" ? Scheme::kDistance
                                                : Scheme::kParallelCounter;
  count(reader, "initiate_above", params.fusion.initiate_above, 0, 100);
  count(reader, "clear_scans", params.fusion.clear_scans, 1, 1000);
  count(reader, "parallel_scans", params.fusion.parallel_scans, 1, 100);
  reader.number("release_distance_m", params.release_distance, 0.0, 1e6);
  count(reader, "release_scans", params.release_scans, 1, 1000);
  reader.number("track_timeout_s", params.track_timeout, 0.1, 3600.0);
  return params;
}

}  // namespace track_correlator
