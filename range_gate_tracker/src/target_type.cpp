#include "target_type.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <tws_core/geometry.h>

namespace range_gate_tracker {
namespace {

constexpr double kSurely = 3.0, kBarely = 2.0;  // [standard deviations]
constexpr int kRenewal = 4;                     // [detections]

/// Standard deviation of a place, in whatever direction it is worst [m].
double placeSigma(const tws::Plot& plot, const WindowParams& params) {
  const PlotSigmas sigmas = sigmasOf(plot, params);
  return std::max(sigmas.range, plot.range * sigmas.azimuth);
}

Eigen::Vector2d placeOf(const tws::Plot& plot) { return tws::planarFromPolar(plot.range, plot.azimuth); }

}  // namespace

TargetType typeOf(TargetType before, TypeBaseline& baseline, const tws::Plot& now, const WindowParams& params) {
  if (baseline.detections == 0) baseline.reference = baseline.next = now;
  const tws::Plot from = baseline.reference;
  if (++baseline.detections % kRenewal == 0) baseline.reference = std::exchange(baseline.next, now);
  const double dt = now.time - from.time;
  if (dt <= 0.0) return before;
  const double distance = (placeOf(now) - placeOf(from)).norm();
  const double sigma = std::hypot(placeSigma(from, params), placeSigma(now, params));
  const auto isFaster = [&](double speed, TargetType type) {
    return distance - (before >= type ? kBarely : kSurely) * sigma > speed * dt;
  };
  if (isFaster(params.air_speed, TargetType::kAircraft)) return TargetType::kAircraft;
  return isFaster(params.least_speed, TargetType::kSurface) ? TargetType::kSurface : TargetType::kStationary;
}

int priorityOf(TargetType type, const WindowKinematics& now, const WindowParams& params) {
  if (type == TargetType::kSurface) return 3;
  if (type != TargetType::kAircraft) return 4;
  return -now.range_rate * params.urgent_time >= now.range ? 1 : 2;
}

}  // namespace range_gate_tracker
