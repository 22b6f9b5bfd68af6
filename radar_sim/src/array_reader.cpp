#include "array_reader.h"

#include <cmath>

#include <tws_core/units.h>

#include "radar_reader.h"
#include "search_raster.h"

namespace radar_sim {
namespace {

using tws::kRadiansPerDegree;

void readFace(ParameterReader& reader, ArrayParams& array) {
  reader.number("antenna_height_m", array.antenna_height, 0.0, 20000.0);
  scaledNumber(reader, "azimuth_deg", array.azimuth, kRadiansPerDegree, 0.0, 360.0);
  scaledNumber(reader, "tilt_deg", array.tilt, kRadiansPerDegree, -10.0, 90.0);
  reader.number("beamwidth_u", array.beamwidth_u, 1e-3, 0.5);
  reader.number("beamwidth_v", array.beamwidth_v, 1e-3, 0.5);
  scaledNumber(reader, "greatest_scan_deg", array.greatest_scan, kRadiansPerDegree, 1.0, 80.0);
}

void readEcho(ParameterReader& reader, ArrayParams& array) {
  double reference_snr_db = 10.0 * std::log10(array.reference_snr);
  reader.number("reference_snr_db", reference_snr_db, -50.0, 100.0);
  array.reference_snr = std::pow(10.0, reference_snr_db / 10.0);
  reader.number("reference_range_m", array.reference_range, 100.0, kFarthest);
  reader.number("scan_loss_exponent", array.scan_loss_exponent, 0.0, 10.0);
  reader.number("false_alarm_probability", array.false_alarm_probability, 1e-15, 0.001);
  reader.number("false_alarms_per_dwell", array.false_alarms_per_dwell, 0.0, 1e4);
  reader.number("range_cell_m", array.range_cell, 0.1, 10000.0);
  reader.number("min_range_m", array.min_range, 10.0, kFarthest);
  reader.number("max_range_m", array.max_range, 100.0, kFarthest);
  if (array.max_range <= array.min_range) reader.fail("max_range_m", "is not greater than min_range_m");
  reader.number("range_sigma_floor_m", array.range_sigma_floor, 0.01, 10000.0);
  reader.number("angle_sigma_floor", array.angle_sigma_floor, 1e-7, 0.1);
}

void readTimes(ParameterReader& reader, ArrayParams& array) {
  reader.number("resource_period_s", array.resource_period, 1e-3, 60.0);
  reader.number("dwell_s", array.dwell_time, 1e-5, 60.0);
  if (array.dwell_time > array.resource_period) reader.fail("dwell_s", "does not fit into resource_period_s");
  reader.number("command_latency_s", array.command_latency, 0.0, 60.0);
}

/// An interval of sine space, the smaller bound first.
void readSineInterval(ParameterReader& reader, const std::string& key, double& from, double& to) {
  Interval interval{from, to};
  readInterval(reader, key, interval, 1.0, -1.0, 1.0);
  from = interval.least;
  to = interval.greatest;
}

void readManager(ParameterReader& reader, ArrayParams& array) {
  readSineInterval(reader, "search_u", array.search_u_from, array.search_u_to);
  readSineInterval(reader, "search_v", array.search_v_from, array.search_v_to);
  reader.number("search_spacing", array.search_spacing, 0.1, 2.0);
  reader.number("search_share", array.search_share, 0.0, 1.0);
  reader.number("revisit_interval_s", array.revisit_interval, 1e-3, 600.0);
  reader.number("sequence_spacing", array.sequence_spacing, 0.1, 1.0);
  reader.number("sequence_distance", array.sequence_distance, 0.0, 10.0);
}

}  // namespace

ArrayParams readArrayRadar(ParameterReader& reader) {
  ArrayParams array;
  readRadarName(reader, array.name);
  reader.text("site", array.site);
  readFace(reader, array);
  readEcho(reader, array);
  readTimes(reader, array);
  readManager(reader, array);
  orFail(reader, "search_u", [&] { return SearchRaster(array).beams().size(); });
  reader.done();
  return array;
}

}  // namespace radar_sim
