#pragma once

#include <tws_msgs/RangeGate.h>
#include <tws_msgs/RangeProfile.h>
#include <tws_msgs/Track.h>
#include <tws_runtime/conversions.h>

#include <cstdint>
#include <string>

#include "range_gate_tracker.h"

namespace range_gate_tracker {

/// Why a profile cannot be used; empty: nothing in the message says so. (The tracker looks at the numbers.)
std::string faultOf(const tws_msgs::RangeProfile& message);

RangeProfile toProfile(const tws_msgs::RangeProfile& message);

tws_msgs::RangeGate toMessage(const GateReport& report, const RangeGateParams& params);

/// The target as a track, still without its place: slant range and rate, azimuth of the beam [rad], NaN when unknown.
/// Locked or coasting only.
tws_msgs::Track toTrack(const GateReport& report, double azimuth, std::uint32_t uid);

/// Sets position, velocity, speed and course from the polar state: what is seen of the velocity, along the beam. NaN
/// without an azimuth.
void place(tws_msgs::Track& track, const tws_runtime::Site& site);

}  // namespace range_gate_tracker
