#include "range_reader.h"

#include <cmath>

#include <tws_core/units.h>

#include "radar_reader.h"

namespace radar_sim {
namespace {

constexpr double kMostBins = 100000.0;

void readBeam(ParameterReader& reader, RangeRadarParams& radar) {
  reader.require("target");
  reader.text("target", radar.target);
  reader.text("site", radar.site);
  reader.number("antenna_height_m", radar.antenna_height, 0.0, 20000.0);
  scaledNumber(reader, "beamwidth_deg", radar.beamwidth, tws::kRadiansPerDegree, 0.01, 90.0);
  reader.number("wavelength_m", radar.wavelength, 1e-4, 10.0);
}

void readGate(ParameterReader& reader, RangeRadarParams& radar) {
  reader.number("profile_rate_hz", radar.profile_rate, 1.0, 1000.0);
  reader.number("bin_size_m", radar.bin_size, 0.01, 1000.0);
  reader.number("resolution_m", radar.resolution, 0.01, 1000.0);
  if (radar.resolution < radar.bin_size)
    reader.fail("resolution_m", "is less than bin_size_m: echoes would fall between the bins");
  reader.number("min_range_m", radar.min_range, 1.0, kFarthest);
  reader.number("max_range_m", radar.max_range, 1.0, kFarthest);
  reader.number("gate_length_m", radar.gate_length, radar.bin_size, kMostBins * radar.bin_size);
  if (radar.max_range < radar.min_range + radar.gate_length)
    reader.fail("max_range_m", "leaves no room for the gate between it and min_range_m");
  reader.number("start_range_m", radar.start_range, radar.min_range, radar.max_range);
  reader.number("latency_s", radar.latency, 0.001, 60.0);
}

void readSeaClutter(ParameterReader reader, GateSeaClutter& clutter) {
  double decibels = -300.0;
  reader.number("sigma0_db", decibels, -100.0, 20.0);
  if (reader.has("sigma0_db")) clutter.sigma0 = std::pow(10.0, decibels / 10.0);
  reader.number("shape", clutter.shape, 0.01, 1e6);
  reader.number("patch_m", clutter.patch_length, 0.1, 1e5);
  reader.number("patch_time_s", clutter.patch_time, 0.001, 1e5);
  reader.done();
}

}  // namespace

RangeRadarParams readRangeRadar(ParameterReader& reader) {
  RangeRadarParams radar;
  readRadarName(reader, radar.name);
  readBeam(reader, radar);
  readGate(reader, radar);
  reader.number("noise_rcs_m2", radar.noise_rcs, 0.0, 1e9);
  reader.number("noise_range_m", radar.noise_range, 1.0, kFarthest);
  readSeaClutter(reader.map("sea_clutter"), radar.sea_clutter);
  reader.done();
  return radar;
}

}  // namespace radar_sim
