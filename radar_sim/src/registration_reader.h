#pragma once

#include "reading.h"
#include "registration_errors.h"

namespace radar_sim {

/// The keys of a radar's own errors in range.
void readRangeErrors(ParameterReader& reader, RegistrationErrors& errors);
/// azimuth_bias_deg, of the turning gear or of a beam on another radar's mast [rad].
void readAzimuthBias(ParameterReader& reader, double& bias);
/// The keys of all other errors, which radars on one mast have together. `start_time` of the scenario [s of data time]:
/// no clock may tell less than 0.
void readMastErrors(ParameterReader& reader, RegistrationErrors& errors, double start_time);
/// Refuses those keys: they are said of another radar.
void refuseMastErrors(const ParameterReader& reader, const std::string& why);

}  // namespace radar_sim
