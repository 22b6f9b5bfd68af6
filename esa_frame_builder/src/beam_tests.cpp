#include "beam_tests.h"

#include <algorithm>
#include <cmath>

namespace esa_frame_builder {

RangeSpan rangeSpanOf(const Dwell& dwell) {
  RangeSpan span;
  double variance = 0.0;
  for (const Measurement& measurement : dwell.measurements) {
    span.least = std::min(span.least, measurement.range);
    span.greatest = std::max(span.greatest, measurement.range);
    variance = std::max(variance, measurement.covariance(0, 0));
  }
  span.sigma = std::sqrt(variance);
  return span;
}

double footprintRadius(const Dwell& dwell, const FrameBuilderParams& params) {
  return params.alpha_0 * std::max(dwell.beamwidth_u, dwell.beamwidth_v);
}

bool beamPointsAreClose(const Dwell& k, const Dwell& n, const FrameBuilderParams& params) {
  return std::abs(k.u - n.u) < params.gamma_u * k.beamwidth_u && std::abs(k.v - n.v) < params.gamma_v * k.beamwidth_v;
}

bool rangesMeet(const SpannedDwell& k, const SpannedDwell& n, const FrameBuilderParams& params) {
  if (k.span.empty() || n.span.empty()) return true;
  const double gamma_r =
      params.max_speed * std::abs(k.dwell.time - n.dwell.time) + std::sqrt(params.range_gate_chi2) * k.span.sigma;
  return k.span.greatest > n.span.least - gamma_r && k.span.least < n.span.greatest + gamma_r;
}

bool passesCoarseTest(const SpannedDwell& k, const SpannedDwell& n, const FrameBuilderParams& params) {
  return beamPointsAreClose(k.dwell, n.dwell, params) && rangesMeet(k, n, params);
}

bool passesFineTest(const Dwell& k, const Dwell& n, const FrameBuilderParams& params) {
  return std::hypot((k.u - n.u) / k.beamwidth_u, (k.v - n.v) / k.beamwidth_v) < 1.0 - params.gamma_theta;
}

bool beamPointTestRejects(const SpannedDwell& k, const SpannedDwell& n, const FrameBuilderParams& params) {
  return passesCoarseTest(k, n, params) && passesFineTest(k.dwell, n.dwell, params);
}

bool mayShareTargets(const SpannedDwell& k, const SpannedDwell& n, const FrameBuilderParams& params) {
  const double reach = footprintRadius(k.dwell, params) + footprintRadius(n.dwell, params);
  return std::hypot(k.dwell.u - n.dwell.u, k.dwell.v - n.dwell.v) < reach && rangesMeet(k, n, params);
}

}  // namespace esa_frame_builder
