#include "frame_builder_params_reader.h"

namespace esa_frame_builder {

FrameBuilderParams readFrameBuilderParams(tws_runtime::ParameterReader& reader) {
  FrameBuilderParams params;
  int algorithm = static_cast<int>(params.algorithm);
  reader.integer("algorithm", algorithm, 1, 4);
  params.algorithm = static_cast<Algorithm>(algorithm);
  reader.number("gamma_u", params.gamma_u, 0.0, 1.0);
  reader.number("gamma_v", params.gamma_v, 0.0, 1.0);
  reader.number("gamma_theta", params.gamma_theta, 0.0, 1.0);
  reader.number("alpha_0", params.alpha_0, 0.1, 10.0);
  reader.number("max_speed_mps", params.max_speed, 1.0, 1e5);
  reader.number("range_gate_chi2", params.range_gate_chi2, 0.0, 100.0);
  reader.number("angle_gate_chi2", params.angle_gate_chi2, 0.0, 100.0);
  reader.number("max_frame_time_s", params.max_frame_time, 1e-3, 600.0);
  reader.integer("least_allowance_periods", params.least_allowance_periods, 0, 10000);
  reader.integer("greatest_allowance_periods", params.greatest_allowance_periods, 0, 10000);
  if (params.least_allowance_periods > params.greatest_allowance_periods)
    reader.fail("least_allowance_periods", "must not be above greatest_allowance_periods");
  std::string rule = "strict", time_test = "expected_next_dwell";
  reader.choice("dwell_group_rule", rule, {"strict", "ratio"});
  params.strict_group_rule = rule == "strict";
  reader.number("dwell_group_ratio", params.group_ratio, 0.0, 1.0);
  reader.choice("time_test", time_test, {"expected_next_dwell", "timer"});
  params.expects_next_dwell = time_test == "expected_next_dwell";
  reader.integer("open_frames", params.open_frames, 1, 100);
  return params;
}

}  // namespace esa_frame_builder
