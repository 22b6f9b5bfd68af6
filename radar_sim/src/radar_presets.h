#pragma once

#include <string>
#include <vector>

#include "radar_params.h"

namespace radar_sim {

/// The ready radar types: "SPS-12", "SPS-39", "SPS-10" and "generic".
std::vector<std::string> radarTypes();

/// Parameters of a ready radar, without name and site. Periods, and the two beams of the SPS-39 in search, are those of
/// NRL Report 7952; the other figures are plausible for naval sets of that time and size, not those of any real one.
/// Throws std::invalid_argument for an unknown type.
RadarParams radarPreset(const std::string& type);

}  // namespace radar_sim
