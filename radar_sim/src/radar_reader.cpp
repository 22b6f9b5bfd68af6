#include "radar_reader.h"

#include <cctype>
#include <cmath>

#include "radar_presets.h"
#include "registration_reader.h"

namespace radar_sim {
namespace {

using tws::kRadiansPerDegree;

ElevationBeam readBeam(ParameterReader& reader) {
  ElevationBeam beam;
  reader.require("elevation_deg");
  reader.require("beamwidth_deg");
  scaledNumber(reader, "elevation_deg", beam.elevation, kRadiansPerDegree, -10.0, 90.0);
  scaledNumber(reader, "beamwidth_deg", beam.beamwidth, kRadiansPerDegree, 0.1, 180.0);
  scaledNumber(reader, "cosecant_to_deg", beam.cosecant_to, kRadiansPerDegree, 0.0, 90.0);
  const double edge = beam.elevation + beam.beamwidth / 2.0;
  if (beam.cosecant_to > 0.0 && beam.cosecant_to < edge)
    reader.fail("cosecant_to_deg", "lies below the beam's upper edge");
  if (beam.cosecant_to > 0.0 && edge <= 0.0)
    reader.fail("cosecant_to_deg", "needs a beam whose upper edge lies above the horizontal");
  reader.done();
  return beam;
}

void readAntenna(ParameterReader& reader, RadarParams& radar) {
  reader.number("rotation_period_s", radar.rotation_period, 0.7, 600.0);
  scaledNumber(reader, "start_azimuth_deg", radar.start_azimuth, kRadiansPerDegree, 0.0, 359.999999);
  reader.number("antenna_height_m", radar.antenna_height, 0.0, 20000.0);
  scaledNumber(reader, "azimuth_beamwidth_deg", radar.azimuth_beamwidth, kRadiansPerDegree, 0.01, 45.0);
  std::vector<ElevationBeam> beams;
  for (ParameterReader& beam : reader.list("beams")) beams.push_back(readBeam(beam));
  if (reader.has("beams") && beams.empty()) reader.fail("beams", "the list is empty");
  if (!beams.empty()) radar.beams = beams;
}

void readRadarEquation(ParameterReader& reader, RadarParams& radar) {
  reader.number("peak_power_w", radar.peak_power, 1e-3, 1e9);
  readDecibels(reader, "antenna_gain_db", radar.antenna_gain, 0.0, 70.0);
  reader.number("wavelength_m", radar.wavelength, 0.001, 10.0);
  reader.number("pulse_width_s", radar.pulse_width, 1e-9, 1e-3);
  readDecibels(reader, "noise_figure_db", radar.noise_figure, 0.0, 30.0);
  readDecibels(reader, "losses_db", radar.losses, 0.0, 60.0);
  reader.number("pulses", radar.pulses, 1.0, 1e6);
  reader.number("integration_efficiency", radar.integration_efficiency, 0.001, 1.0);
  reader.number("false_alarm_probability", radar.false_alarm_probability, 1e-15, 0.001);
  reader.number("sea_reflection", radar.sea_reflection, 0.0, 1.0);
}

void readMeasurement(ParameterReader& reader, RadarParams& radar) {
  reader.number("min_range_m", radar.min_range, 10.0, kFarthest);
  reader.number("max_range_m", radar.max_range, 100.0, kFarthest);
  if (radar.max_range <= radar.min_range) reader.fail("max_range_m", "is not greater than min_range_m");
  reader.number("range_sigma_m", radar.range_sigma, 0.0, 10000.0);
  scaledNumber(reader, "azimuth_sigma_deg", radar.azimuth_sigma, kRadiansPerDegree, 0.0, 20.0);
  reader.flag("snr_dependent_noise", radar.snr_dependent_noise);
  reader.number("range_rate_sigma_mps", radar.range_rate_sigma, 0.0, 1000.0);
  reader.number("range_rate_span_mps", radar.range_rate_span, 0.0, 20000.0);
  reader.number("range_rate_ambiguity_mps", radar.range_rate_ambiguity, 0.0, 20000.0);
  reader.number("range_lsb_m", radar.range_lsb, 0.0, 10000.0);
  scaledNumber(reader, "azimuth_lsb_deg", radar.azimuth_lsb, kRadiansPerDegree, 0.0, 10.0);
  // A tick must be shorter than the time in one sector, or plots could not lie within theirs.
  reader.number("time_lsb_s", radar.time_lsb, 0.0, radar.rotation_period / 64.0);
  reader.number("false_alarms_per_scan", radar.false_alarms_per_scan, 0.0, 1e6);
  readDecibels(reader, "clutter_suppression_db", radar.clutter_suppression, 0.0, 100.0);
  std::string by = radar.false_alarms_by_area ? "area" : "cell";
  reader.choice("false_alarms_by", by, {"area", "cell"});
  radar.false_alarms_by_area = by == "area";
}

void readElevationSearch(ParameterReader& reader, std::optional<ElevationSearchParams>& search) {
  ParameterReader map = reader.map("elevation_search");
  if (!reader.has("elevation_search")) return;
  ElevationSearchParams p = search.value_or(ElevationSearchParams{});
  map.integer("per_turn", p.per_turn, 0, 1000);
  map.integer("scans", p.scans, 1, 64);
  scaledNumber(map, "width_deg", p.width, kRadiansPerDegree, 0.1, 90.0);
  map.number("range_interval_m", p.range_interval, 10.0, kFarthest);
  scaledNumber(map, "beamwidth_deg", p.beamwidth, kRadiansPerDegree, 0.1, 90.0);
  scaledNumber(map, "max_elevation_deg", p.max_elevation, kRadiansPerDegree, 1.0, 90.0);
  map.number("pulses", p.pulses, 1.0, 1e6);
  scaledNumber(map, "elevation_sigma_deg", p.elevation_sigma, kRadiansPerDegree, 0.0, 10.0);
  map.done();
  search = p;
}

}  // namespace

void readRadarName(ParameterReader& reader, std::string& name) {
  readName(reader, name);
  if (std::isalpha(static_cast<unsigned char>(name[0])) == 0 || name.find('-') != std::string::npos) {
    reader.fail("name", "'" + name + "' cannot be a topic's name: a letter first, then letters, digits and _");
  }
  if (name == "map") reader.fail("name", "'map' is the frame of the whole scenario");
}

RadarParams readRadar(ParameterReader& reader, double start_time) {
  std::string type = "generic";
  reader.choice("type", type, radarTypes());
  RadarParams radar = radarPreset(type);
  readRadarName(reader, radar.name);
  reader.text("site", radar.site);
  readAntenna(reader, radar);
  readRadarEquation(reader, radar);
  readMeasurement(reader, radar);
  readRangeErrors(reader, radar.errors);
  readAzimuthBias(reader, radar.errors.azimuth.bias);
  readMastErrors(reader, radar.errors, start_time);
  readElevationSearch(reader, radar.elevation_search);
  reader.done();
  return radar;
}

}  // namespace radar_sim
