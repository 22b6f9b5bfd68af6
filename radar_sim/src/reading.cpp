#include "reading.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <tws_core/units.h>

#include "scenario.h"

namespace radar_sim {
namespace {

/// Both keys of a pair must be there, or neither.
bool hasPair(const ParameterReader& reader, const std::string& a, const std::string& b) {
  if (reader.has(a) != reader.has(b))
    reader.fail(reader.has(a) ? a : b, "needs " + (reader.has(a) ? b : a) + " beside it");
  return reader.has(a);
}

Fluctuation fluctuationOf(long swerling) {
  return swerling == 0 ? Fluctuation::kSteady : swerling == 1 ? Fluctuation::kExponential : Fluctuation::kOneDominant;
}

}  // namespace

void readDecibels(ParameterReader& reader, const std::string& key, double& ratio, double least, double greatest) {
  double decibels = 10.0 * std::log10(ratio);
  reader.number(key, decibels, least, greatest);
  if (reader.has(key)) ratio = std::pow(10.0, decibels / 10.0);
}

void readInterval(ParameterReader& reader, const std::string& key, Interval& value, double unit, double least,
                  double greatest) {
  std::vector<double> read;
  reader.numbers(key, read, least, greatest);
  if (!reader.has(key)) return;
  if (read.size() != 2) reader.fail(key, "expected two numbers, [least, greatest]");
  if (read[0] > read[1]) reader.fail(key, "the first number is greater than the second");
  value = {read[0] * unit, read[1] * unit};
}

void readSpeed(ParameterReader& reader, double& speed) {
  if (reader.has("speed_mps") && reader.has("speed_kn"))
    reader.fail("speed_kn", "stands beside speed_mps: one of them only");
  reader.number("speed_mps", speed, 0.0, 3000.0);
  scaledNumber(reader, "speed_kn", speed, tws::kMetresPerSecondPerKnot, 0.0, 6000.0);
}

void readSpeed(ParameterReader& reader, Interval& speed, double greatest) {
  if (reader.has("speed_mps") && reader.has("speed_kn"))
    reader.fail("speed_kn", "stands beside speed_mps: one of them only");
  readInterval(reader, "speed_mps", speed, 1.0, 0.0, greatest);
  readInterval(reader, "speed_kn", speed, tws::kMetresPerSecondPerKnot, 0.0, greatest / tws::kMetresPerSecondPerKnot);
}

Eigen::Vector2d readPlace(ParameterReader& reader, const ReadingContext& context,
                          const std::optional<Eigen::Vector2d>& fallback) {
  double east = 0.0, north = 0.0, range = 0.0, azimuth = 0.0;
  tws::Geodetic place;
  reader.number("east_m", east, -kFarthest, kFarthest);
  reader.number("north_m", north, -kFarthest, kFarthest);
  scaledNumber(reader, "latitude_deg", place.latitude, tws::kRadiansPerDegree, -90.0, 90.0);
  scaledNumber(reader, "longitude_deg", place.longitude, tws::kRadiansPerDegree, -360.0, 360.0);
  reader.number("range_m", range, 0.0, kFarthest);
  scaledNumber(reader, "azimuth_deg", azimuth, tws::kRadiansPerDegree, 0.0, 360.0);
  const bool enu = hasPair(reader, "east_m", "north_m");
  const bool geodetic = hasPair(reader, "latitude_deg", "longitude_deg");
  const bool polar = hasPair(reader, "range_m", "azimuth_deg");
  if (enu + geodetic + polar > 1) reader.fail(geodetic ? "latitude_deg" : "range_m", "the place is given twice");
  if (geodetic) return context.map.toEnu(place).head<2>();
  if (polar) return {range * std::sin(azimuth), range * std::cos(azimuth)};
  if (!enu && fallback) return *fallback;
  reader.require("east_m");
  return {east, north};
}

void readReflection(ParameterReader& reader, Reflection& reflection, bool with_rcs) {
  if (with_rcs) reader.number("rcs_m2", reflection.rcs, 1e-6, 1e7);
  // A radar cross-section asks for the radar equation, also where a kind's default is a stated chance.
  if (with_rcs && reader.has("rcs_m2")) reflection.detection_probability = std::numeric_limits<double>::quiet_NaN();
  long swerling = -1;
  reader.integer("swerling", swerling, 0, 3);
  if (swerling == 2) reader.fail("swerling", "2 fluctuates from pulse to pulse and is not modelled: 0, 1 or 3");
  if (swerling >= 0) reflection.fluctuation = fluctuationOf(swerling);
  reader.number("detection_probability", reflection.detection_probability, 0.01, 0.999);
  if (with_rcs && reader.has("rcs_m2") && reader.has("detection_probability")) {
    reader.fail("detection_probability", "stands beside rcs_m2: one of them only");
  }
  reader.number("jitter_m", reflection.jitter, 0.0, 10000.0);
}

void readName(ParameterReader& reader, std::string& name) {
  reader.text("name", name);
  if (name.empty()) reader.require("name");
  const auto isAllowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
  if (name.empty() || !std::all_of(name.begin(), name.end(), isAllowed)) {
    reader.fail("name", "'" + name + "' is not made of letters, digits, - and _");
  }
}

void settleSite(std::string& site, const Scenario& scenario, const ParameterReader& reader) {
  if (site.empty() && scenario.sites.size() > 1) reader.fail("site", "is required, as there are several sites");
  if (site.empty()) site = scenario.sites.front().name;
  const auto isItsSite = [&](const Site& known) { return known.name == site; };
  if (std::none_of(scenario.sites.begin(), scenario.sites.end(), isItsSite))
    reader.fail("site", "there is no site '" + site + "'");
}

}  // namespace radar_sim
