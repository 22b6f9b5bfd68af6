#include "secondary_reader.h"

#include <algorithm>

#include <tws_core/units.h>

#include "radar_reader.h"
#include "registration_reader.h"
#include "reply.h"

namespace radar_sim {
namespace {

using tws::kRadiansPerDegree;

const char* const kOfTheMast = "is that of on_mast_of: one of them only";

void readOwnMast(ParameterReader& reader, double start_time, SecondaryParams& radar) {
  reader.text("site", radar.site);
  reader.number("rotation_period_s", radar.rotation_period, 0.7, 600.0);
  scaledNumber(reader, "start_azimuth_deg", radar.start_azimuth, kRadiansPerDegree, 0.0, 359.999999);
  reader.number("time_lsb_s", radar.time_lsb, 0.0, radar.rotation_period / 64.0);
  readAzimuthBias(reader, radar.errors.azimuth.bias);
  readMastErrors(reader, radar.errors, start_time);
}

/// Rotation, clock, their errors and place are those of the radar on whose mast it turns.
void readSharedMast(ParameterReader& reader, const std::vector<RadarParams>& radars, SecondaryParams& radar) {
  std::vector<std::string> names;
  names.reserve(radars.size());
  for (const RadarParams& primary : radars) names.push_back(primary.name);
  reader.choice("on_mast_of", radar.mast, names);
  for (const char* key : {"site", "rotation_period_s", "start_azimuth_deg", "time_lsb_s"})
    if (reader.has(key)) reader.fail(key, kOfTheMast);
  refuseMastErrors(reader, kOfTheMast);
  readAzimuthBias(reader, radar.beam_offset);
  const auto isTheMast = [&](const RadarParams& primary) { return primary.name == radar.mast; };
  const RadarParams& primary = *std::find_if(radars.begin(), radars.end(), isTheMast);
  radar.site = primary.site;
  radar.rotation_period = primary.rotation_period;
  radar.start_azimuth = primary.start_azimuth;
  radar.time_lsb = primary.time_lsb;
  radar.antenna_height = primary.antenna_height;
  radar.errors.azimuth = primary.errors.azimuth;
  radar.errors.tilt = primary.errors.tilt;
  radar.errors.tilt_azimuth = primary.errors.tilt_azimuth;
  radar.errors.clock = primary.errors.clock;
}

void readInterlace(ParameterReader& reader, std::vector<Mode>& interlace) {
  std::vector<std::string> names;
  reader.texts("interlace", names);
  if (!reader.has("interlace")) return;
  if (names.empty()) reader.fail("interlace", "the list is empty");
  interlace.clear();
  for (const std::string& name : names) {
    const std::vector<std::string> known{"1", "2", "3A", "C"};
    const auto found = std::find(known.begin(), known.end(), name);
    if (found == known.end()) reader.fail("interlace", "'" + name + "' is not one of 1, 2, 3A, C");
    interlace.push_back(static_cast<Mode>(found - known.begin()));
  }
}

void readInterrogation(ParameterReader& reader, SecondaryParams& radar) {
  scaledNumber(reader, "azimuth_beamwidth_deg", radar.azimuth_beamwidth, kRadiansPerDegree, 0.01, 45.0);
  reader.number("interrogation_rate_hz", radar.interrogation_rate, 1.0, 5000.0);
  readInterlace(reader, radar.interlace);
  reader.number("missed_reply_probability", radar.missed_reply_probability, 0.0, 1.0);
  reader.integer("needed_replies", radar.needed_replies, 1, 10000);
  reader.integer("needed_code_replies", radar.needed_code_replies, 1, 10000);
  reader.number("fruit_plots_per_scan", radar.fruit_plots_per_scan, 0.0, 1e6);
  const double interrogations =
      radar.azimuth_beamwidth / tws::kTwoPi * radar.rotation_period * radar.interrogation_rate;
  if (interrogations < static_cast<double>(radar.needed_replies))
    reader.fail("needed_replies",
                "cannot be had: the beam is on an aircraft for " + std::to_string(interrogations) + " interrogations");
}

void readMeasurement(ParameterReader& reader, SecondaryParams& radar) {
  reader.number("min_range_m", radar.min_range, 10.0, kFarthest);
  reader.number("max_range_m", radar.max_range, 100.0, kFarthest);
  if (radar.max_range <= radar.min_range) reader.fail("max_range_m", "is not greater than min_range_m");
  const double unambiguous = kSpeedOfLight / 2.0 / radar.interrogation_rate;
  if (radar.max_range > unambiguous)
    reader.fail("max_range_m", "replies from there come after the next interrogation: " + std::to_string(unambiguous) +
                                   " m at most at this interrogation_rate_hz");
  readRangeErrors(reader, radar.errors);
  reader.number("range_sigma_m", radar.range_sigma, 0.0, 10000.0);
  scaledNumber(reader, "azimuth_sigma_deg", radar.azimuth_sigma, kRadiansPerDegree, 0.0, 20.0);
  reader.number("range_lsb_m", radar.range_lsb, 0.0, 10000.0);
  scaledNumber(reader, "azimuth_lsb_deg", radar.azimuth_lsb, kRadiansPerDegree, 0.0, 10.0);
}

}  // namespace

SecondaryParams readSecondaryRadar(ParameterReader& reader, const std::vector<RadarParams>& radars, double start_time) {
  SecondaryParams radar;
  readRadarName(reader, radar.name);
  if (reader.has("on_mast_of"))
    readSharedMast(reader, radars, radar);
  else
    readOwnMast(reader, start_time, radar);
  reader.number("antenna_height_m", radar.antenna_height, 0.0, 20000.0);
  readInterrogation(reader, radar);
  readMeasurement(reader, radar);
  reader.done();
  return radar;
}

}  // namespace radar_sim
