#pragma once

#include <limits>
#include <string>
#include <vector>

namespace adit_tracker {

/// What the command line says of a radar: ID[:PERIOD_S[:PHASE_DEG]].
struct RadarSpec {
  std::string id;
  double period = 0.0;                                      // of a turn [s]; 0: to be found
  double phase = std::numeric_limits<double>::quiet_NaN();  // azimuth of the beam at t = 0 [rad]; NaN: to be found
};

/// Throws std::invalid_argument, which says what was expected. The period is in [0.5, 120] s.
RadarSpec parseRadar(const std::string& text);

/// The same of several; an ID that stands twice is refused as well.
std::vector<RadarSpec> parseRadars(const std::vector<std::string>& texts);

}  // namespace adit_tracker
