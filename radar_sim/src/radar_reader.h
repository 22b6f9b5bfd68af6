#pragma once

#include "radar_params.h"
#include "reading.h"

namespace radar_sim {

/// One entry of the scenario's list `radars`: a type and what differs from it. `start_time` of the scenario [s].
RadarParams readRadar(ParameterReader& reader, double start_time);

/// `name` of a radar: it becomes the first part of topic names, and a frame beside "map".
void readRadarName(ParameterReader& reader, std::string& name);

}  // namespace radar_sim
