#include "secondary_params_reader.h"

namespace track_correlator {
namespace {

using tws_runtime::ParameterReader;

void degrees(ParameterReader& reader, const std::string& key, double& radians, double least, double greatest) {
  double value = 0.0;
  reader.number(key, value, least, greatest);
  if (reader.has(key)) radians = tws::radians(value);
}

void count(ParameterReader& reader, const std::string& key, int& value, long least, long greatest) {
  long number = value;
  reader.integer(key, number, least, greatest);
  value = static_cast<int>(number);
}

}  // namespace

SecondaryParams readSecondaryParams(ParameterReader& reader) {
  SecondaryParams params;
  count(reader, "delay_sectors", params.delay_sectors, 2, 32);
  reader.number("range_sigma_m", params.range_sigma, 0.1, 1e5);
  degrees(reader, "azimuth_sigma_deg", params.azimuth_sigma, 1e-4, 20.0);
  reader.number("acceleration_density", params.acceleration_density, 0.0, 1e6);
  reader.number("speed_sigma_mps", params.speed_sigma, 0.1, 1e5);
  reader.number("gate", params.gate, 0.1, 1000.0);
  reader.number("code_gate_m", params.code_gate, 0.0, 1e6);
  reader.number("unknown_code_cost", params.unknown_code_cost, 0.0, 1000.0);
  reader.number("different_code_cost", params.different_code_cost, 0.0, 1000.0);
  reader.number("garble_range_m", params.garble_range, 0.0, 1e5);
  degrees(reader, "garble_azimuth_deg", params.garble_azimuth, 0.0, 45.0);
  count(reader, "code_change_replies", params.code_change_replies, 1, 100);
  reader.number("climb_limit_mps", params.climb_limit, 0.1, 1e4);
  reader.number("split_distance_m", params.split_distance, 0.0, 1e5);
  count(reader, "confirm_plots", params.confirm_plots, 1, 100);
  count(reader, "tentative_misses", params.tentative_misses, 1, 100);
  count(reader, "drop_misses", params.drop_misses, 1, 1000);
  return params;
}

}  // namespace track_correlator
