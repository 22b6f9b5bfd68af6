#include "window_params.h"

#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/axis_checks.h>

namespace range_gate_tracker {
namespace {

void requirePositive(double value, const char* name) {
  tws::requireNumber(value > 0.0 && std::isfinite(value), name, value, "above 0");
}

void requireAtLeast(double value, double least, const char* name, const char* range) {
  tws::requireNumber(value >= least && std::isfinite(value), name, value, range);
}

}  // namespace

void check(const WindowParams& params) {
  (void)tws::AxisFilter(params.filter);
  requirePositive(params.greatest_speed, "greatest_speed");
  requireAtLeast(params.greatest_acceleration, 0.0, "greatest_acceleration", "at least 0");
  requirePositive(params.manoeuvre, "manoeuvre");
  requirePositive(params.range_sigma, "range_sigma");
  requirePositive(params.azimuth_sigma, "azimuth_sigma");
  requirePositive(params.window_sigmas, "window_sigmas");
  requirePositive(params.error_weight, "error_weight");
  tws::requireNumber(params.error_weight <= 1.0, "error_weight", params.error_weight, "in (0, 1]");
  requirePositive(params.widest, "widest");
  tws::requireNumber(params.widest <= tws::kPi / 2.0, "widest", params.widest, "at most a quarter of a turn");
  requireAtLeast(params.firm_hits, 2, "firm_hits", "at least 2");
  requireAtLeast(params.acquisition_scans, 1, "acquisition_scans", "at least 1");
  requireAtLeast(params.missed_scans, 1, "missed_scans", "at least 1");
  requireAtLeast(static_cast<double>(params.capacity), 2, "capacity", "at least 2");
  requireAtLeast(params.least_speed, 0.0, "least_speed", "at least 0");
  requireAtLeast(params.air_speed, params.least_speed, "air_speed", "at least least_speed");
  requireAtLeast(params.urgent_time, 0.0, "urgent_time", "at least 0");
  requirePositive(params.period, "period");
}

}  // namespace range_gate_tracker
