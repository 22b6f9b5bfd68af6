#pragma once

#include <tws_core/sea_level.h>
#include <tws_msgs/TrackDatabase.h>
#include <tws_msgs/Tracks.h>

#include "frame_tracker.h"
#include "mfa_stub_params.h"

namespace esa_frame_builder {

/// `array`: where it stands in the frame of positions [m].
tws_msgs::Track trackMessage(const TrackUpdate& update, const Eigen::Vector3d& array, const tws::SeaLevel& sea,
                             const std::string& radar);

/// The track moved on to `time` [s].
tws_msgs::TrackDatabaseEntry databaseEntry(const FrameTrack& track, double time, const MfaStubParams& params);

}  // namespace esa_frame_builder
