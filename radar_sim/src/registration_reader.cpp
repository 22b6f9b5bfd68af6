#include "registration_reader.h"

#include <tws_core/units.h>

namespace radar_sim {
namespace {

using tws::kRadiansPerDegree;

constexpr double kRadiansPerSecond = kRadiansPerDegree / 3600.0;  // of a degree an hour

}  // namespace

void readRangeErrors(ParameterReader& reader, RegistrationErrors& errors) {
  reader.number("range_bias_m", errors.range_bias, -10000.0, 10000.0);
  reader.number("range_gain", errors.range_gain, -0.1, 0.1);
  reader.flag("air_delay", errors.air_delays);
}

void readAzimuthBias(ParameterReader& reader, double& bias) {
  scaledNumber(reader, "azimuth_bias_deg", bias, kRadiansPerDegree, -20.0, 20.0);
}

// The bounds keep the measured azimuth growing as the antenna turns, whatever its speed.
void readMastErrors(ParameterReader& reader, RegistrationErrors& errors, double start_time) {
  AzimuthErrors& azimuth = errors.azimuth;
  scaledNumber(reader, "eccentricity_deg", azimuth.eccentricity, kRadiansPerDegree, 0.0, 5.0);
  scaledNumber(reader, "eccentricity_phase_deg", azimuth.eccentricity_phase, kRadiansPerDegree, -360.0, 360.0);
  scaledNumber(reader, "north_drift_deg_h", azimuth.north_drift, kRadiansPerSecond, -360.0, 360.0);
  scaledNumber(reader, "tilt_deg", errors.tilt, kRadiansPerDegree, 0.0, 5.0);
  scaledNumber(reader, "tilt_azimuth_deg", errors.tilt_azimuth, kRadiansPerDegree, -360.0, 360.0);
  reader.number("clock_offset_s", errors.clock.offset, -60.0, 60.0);
  scaledNumber(reader, "clock_drift_ppm", errors.clock.drift, 1e-6, -1000.0, 1000.0);
  if (start_time + errors.clock.offset < 0.0)
    reader.fail("clock_offset_s", "sets the clock below 0 at the scenario's start (start_time_s)");
}

void refuseMastErrors(const ParameterReader& reader, const std::string& why) {
  for (const char* key : {"eccentricity_deg", "eccentricity_phase_deg", "north_drift_deg_h", "tilt_deg",
                          "tilt_azimuth_deg", "clock_offset_s", "clock_drift_ppm"})
    if (reader.has(key)) reader.fail(key, why);
}

}  // namespace radar_sim
