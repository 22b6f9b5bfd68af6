#include "io/radar_spec.h"

#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>
#include <stdexcept>

#include <tws_core/units.h>

namespace adit_tracker {
namespace {

/// NaN: it is none.
double number(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return text.empty() || *end != '\0' || !std::isfinite(value) ? std::numeric_limits<double>::quiet_NaN() : value;
}

}  // namespace

RadarSpec parseRadar(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ':');) parts.push_back(part);
  const auto refuse = [&](const char* why) { throw std::invalid_argument("--radar " + text + ": " + why); };
  const char* const kForm = "expected ID[:PERIOD_S[:PHASE_DEG]]";
  if (parts.empty() || parts.size() > 3 || parts[0].empty() || text.back() == ':') refuse(kForm);
  RadarSpec spec;
  spec.id = parts[0];
  if (parts.size() > 1) {
    spec.period = number(parts[1]);
    if (std::isnan(spec.period)) refuse(kForm);
    if (spec.period < 0.5 || spec.period > 120.0) refuse("the period is not in [0.5, 120] s");
  }
  if (parts.size() > 2) {
    spec.phase = tws::radians(number(parts[2]));
    if (std::isnan(spec.phase)) refuse(kForm);
  }
  return spec;
}

std::vector<RadarSpec> parseRadars(const std::vector<std::string>& texts) {
  std::vector<RadarSpec> specs;
  std::set<std::string> ids;
  for (const std::string& text : texts) {
    specs.push_back(parseRadar(text));
    if (!ids.insert(specs.back().id).second) throw std::invalid_argument("--radar " + text + ": that ID stands twice");
  }
  return specs;
}

}  // namespace adit_tracker
