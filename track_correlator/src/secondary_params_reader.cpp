#include "secondary_params_reader.h"

#include <tws_core/units.h>

namespace track_correlator {

SecondaryParams readSecondaryParams(tws_runtime::ParameterReader& reader) {
  SecondaryParams params;
  reader.integer("delay_sectors", params.delay_sectors, 2, 32);
  reader.number("range_sigma_m", params.range_sigma, 0.1, 1e5);
  scaledNumber(reader, "azimuth_sigma_deg", params.azimuth_sigma, tws::kRadiansPerDegree, 1e-4, 20.0);
  reader.number("acceleration_density", params.acceleration_density, 0.0, 1e6);
  reader.number("speed_sigma_mps", params.speed_sigma, 0.1, 1e5);
  reader.number("gate", params.gate, 0.1, 1000.0);
  reader.number("code_gate_m", params.code_gate, 0.0, 1e6);
  reader.number("unknown_code_cost", params.unknown_code_cost, 0.0, 1000.0);
  reader.number("different_code_cost", params.different_code_cost, 0.0, 1000.0);
  reader.number("garble_range_m", params.garble_range, 0.0, 1e5);
  scaledNumber(reader, "garble_azimuth_deg", params.garble_azimuth, tws::kRadiansPerDegree, 0.0, 45.0);
  reader.integer("code_change_replies", params.code_change_replies, 1, 100);
  reader.number("climb_limit_mps", params.climb_limit, 0.1, 1e4);
  reader.number("split_distance_m", params.split_distance, 0.0, 1e5);
  reader.integer("confirm_plots", params.confirm_plots, 1, 100);
  reader.integer("tentative_misses", params.tentative_misses, 1, 100);
  reader.integer("drop_misses", params.drop_misses, 1, 1000);
  return params;
}

}  // namespace track_correlator
