#pragma once

#include <string>

#include <tws_msgs/CorrelatedTrack.h>
#include <tws_msgs/Track.h>

#include "correlator.h"

namespace track_correlator {

/// Why a track cannot be used, e.g. "range is nan"; empty: it can.
std::string faultOf(const tws_msgs::Track& track);

/// A tracker's track on the plane of slant range and azimuth. Without a covariance these standard deviations hold, of
/// position [m] and velocity [m/s].
TrackInput toInput(const tws_msgs::Track& track, double position_sigma, double velocity_sigma);

/// What the correlator says, with the latest updates of the two tracks (null: there is none), brought to `time` [s]:
/// the primary's kinematics, the secondary's codes and height.
tws_msgs::CorrelatedTrack toMessage(const CorrelatedUpdate& update, const tws_msgs::Track* primary,
                                    const tws_msgs::Track* secondary, double time);

}  // namespace track_correlator
