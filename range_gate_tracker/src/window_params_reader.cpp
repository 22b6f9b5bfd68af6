#include "window_params_reader.h"

#include <tws_core/units.h>

namespace range_gate_tracker {
namespace {

using tws_runtime::ParameterReader;

constexpr double kMost = 1e6;

/// True when the first of two choices was made.
bool isFirst(ParameterReader& reader, const std::string& key, bool otherwise, const std::string& first,
             const std::string& second) {
  std::string chosen = otherwise ? first : second;
  reader.choice(key, chosen, {first, second});
  return chosen == first;
}

void readFilter(ParameterReader reader, tws::AxisFilterParams& filter) {
  reader.choice("kind", filter.kind, tws::axisFilterKinds());
  reader.number("alpha", filter.alpha, 0.0, 2.0);
  reader.number("beta", filter.beta, 0.0, 4.0);
  reader.number("gamma", filter.gamma, 0.0, 8.0);
  reader.integer("degree", filter.degree, 0, 2);
  reader.integer("length", filter.length, 1, tws::FixedMemoryState::kMost);
  reader.number("theta", filter.theta, 0.0, 0.9999);
  reader.number("damping", filter.adaptive.damping, 0.01, 0.99);
  reader.number("omega_a", filter.adaptive.omega_a, 1e-6, 100.0);
  reader.number("omega_b", filter.adaptive.omega_b, 1e-6, 100.0);
  reader.number("omega_min", filter.adaptive.omega_min, 1e-6, 100.0);
  reader.number("omega_max", filter.adaptive.omega_max, 1e-6, 100.0);
  reader.done();
}

void readWindows(ParameterReader& reader, WindowParams& params) {
  reader.number("greatest_speed_mps", params.greatest_speed, 0.1, 1e5);
  reader.number("greatest_acceleration_mps2", params.greatest_acceleration, 0.0, 1e4);
  reader.number("manoeuvre_mps2", params.manoeuvre, 1e-6, 1e4);
  reader.number("range_sigma_m", params.range_sigma, 0.1, 1e5);
  scaledNumber(reader, "azimuth_sigma_deg", params.azimuth_sigma, tws::kRadiansPerDegree, 1e-4, 20.0);
  reader.number("window_sigmas", params.window_sigmas, 0.5, 20.0);
  reader.number("error_weight", params.error_weight, 0.001, 1.0);
  scaledNumber(reader, "widest_deg", params.widest, tws::kRadiansPerDegree, 1.0, 90.0);
  const bool centre = params.ambiguity == Ambiguity::kCentreOfGravity;
  params.ambiguity = isFirst(reader, "ambiguity", centre, "centre_of_gravity", "nearest") ? Ambiguity::kCentreOfGravity
                                                                                          : Ambiguity::kNearest;
  const bool momentum = params.overlap == Overlap::kMomentum;
  params.overlap = isFirst(reader, "overlap", momentum, "momentum", "share") ? Overlap::kMomentum : Overlap::kShare;
}

}  // namespace

WindowParams readWindowParams(ParameterReader& reader) {
  WindowParams params;
  readFilter(reader.map("filter"), params.filter);
  params.cartesian = isFirst(reader, "coordinates", params.cartesian, "cartesian", "polar");
  readWindows(reader, params);
  reader.flag("automatic", params.automatic);
  reader.integer("firm_hits", params.firm_hits, 2, 1000);
  reader.integer("acquisition_scans", params.acquisition_scans, 1, 1000);
  reader.integer("missed_scans", params.missed_scans, 1, 1000);
  reader.integer("capacity", params.capacity, 2, 1000001);
  reader.number("least_speed_mps", params.least_speed, 0.0, 1e5);
  reader.number("air_speed_mps", params.air_speed, 0.0, 1e5);
  reader.number("urgent_time_s", params.urgent_time, 0.0, kMost);
  reader.number("period_s", params.period, 0.5, 120.0);
  return params;
}

}  // namespace range_gate_tracker
