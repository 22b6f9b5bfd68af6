#include "mfa_stub_params_reader.h"

namespace esa_frame_builder {

MfaStubParams readMfaStubParams(tws_runtime::ParameterReader& reader) {
  MfaStubParams params;
  reader.integer("window_frames", params.window_frames, 2, 1000);
  reader.integer("initiation_hits", params.initiation_hits, 1, 100);
  reader.integer("initiation_frames", params.initiation_frames, 1, 1000);
  if (params.initiation_hits > params.initiation_frames)
    reader.fail("initiation_hits", "must not be above initiation_frames");
  reader.number("gate_chi2", params.gate_chi2, 0.1, 1000.0);
  reader.number("acceleration_density", params.acceleration_density, 0.0, 1e6);
  reader.number("speed_sigma_mps", params.speed_sigma, 0.1, 1e5);
  reader.number("extraneous_density", params.extraneous_density, 1e-20, 1.0);
  reader.number("false_alarm_probability", params.false_alarm_probability, 1e-12, 0.1);
  reader.number("least_detection_probability", params.least_detection_probability, 1e-3, 0.5);
  reader.number("range_resolution_m", params.range_resolution, 0.0, 1e5);
  reader.number("drop_score", params.drop_score, 0.1, 1000.0);
  reader.number("greatest_coast_s", params.greatest_coast, 0.1, 3600.0);
  reader.number("duplicate_chi2", params.duplicate_chi2, 0.0, 1000.0);
  reader.number("tentative_revisit_s", params.tentative_revisit, 1e-3, 600.0);
  reader.number("firm_revisit_s", params.firm_revisit, 1e-3, 600.0);
  return params;
}

}  // namespace esa_frame_builder
