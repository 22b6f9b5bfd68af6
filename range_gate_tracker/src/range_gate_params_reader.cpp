#include "range_gate_params_reader.h"

#include <cmath>
#include <limits>

namespace range_gate_tracker {
namespace {

using tws_runtime::ParameterReader;

void readMeasuring(ParameterReader& reader, RangeGateParams& params) {
  std::string background = "local";
  reader.number("window_m", params.window, 0.01, 1e5);
  reader.choice("background", background, {"none", "local", "global"});
  params.background = background == "none"    ? Background::kNone
                      : background == "local" ? Background::kLocal
                                              : Background::kGlobal;
  reader.number("threshold_m2", params.threshold, 0.0, 1e9);
  reader.number("damping_time_s", params.damping_time, 0.001, 1000.0);
  reader.number("velocity_limit_mps", params.velocity_limit, 0.01, 20000.0);
  reader.number("prediction_time_s", params.prediction_time, 0.0, 60.0);
  double jump_limit = 0.0;
  reader.number("jump_limit_m", jump_limit, 0.0, 1e5);
  if (jump_limit > 0.0) params.jump_limit = jump_limit;
}

void readPredictor(ParameterReader& reader, RangeGateParams& params) {
  std::string predictor = "damped";
  reader.choice("predictor", predictor, {"damped", "kalman"});
  params.predictor = predictor == "kalman" ? Predictor::kKalman : Predictor::kDamped;
  reader.number("range_sigma_m", params.range_sigma, 0.001, 1e4);
  reader.number("acceleration_density", params.acceleration_density, 1e-6, 1e6);
}

void readGate(ParameterReader& reader, RangeGateParams& params) {
  reader.number("gate_length_m", params.gate_length, 1.0, 1e5);
  reader.number("min_range_m", params.min_range, 0.0, 1e7);
  reader.number("max_range_m", params.max_range, 1.0, 1e7);
  reader.number("coast_time_s", params.coast_time, 0.001, 600.0);
  reader.number("widest_gate_m", params.widest_gate, 1.0, 1e5);
  reader.number("widening_time_s", params.widening_time, 0.001, 3600.0);
  reader.number("sweep_dwell_s", params.sweep_dwell, 0.001, 60.0);
  reader.integer("confirming_profiles", params.confirming_profiles, 1, 1000);
}

}  // namespace

RangeGateParams readRangeGateParams(ParameterReader& reader) {
  RangeGateParams params;
  readMeasuring(reader, params);
  readPredictor(reader, params);
  readGate(reader, params);
  if (params.window > params.gate_length) reader.fail("window_m", "is larger than the gate, gate_length_m");
  if (params.max_range < params.min_range + params.gate_length)
    reader.fail("max_range_m", "leaves no room for the gate between it and min_range_m");
  if (params.widest_gate < params.gate_length) reader.fail("widest_gate_m", "is less than gate_length_m");
  if (params.widening_time < params.coast_time) reader.fail("widening_time_s", "is less than coast_time_s");
  return params;
}

}  // namespace range_gate_tracker
