#pragma once

#include <tws_msgs/TrackDatabase.h>
#include <tws_msgs/Tracks.h>

#include "array_pose.h"
#include "frame_tracker.h"
#include "mfa_stub_params.h"

namespace esa_frame_builder {

tws_msgs::Track trackMessage(const TrackWord& word, const ArrayPose& pose, const std::string& radar);

/// The track moved on to `time` [s].
tws_msgs::TrackDatabaseEntry databaseEntry(const FrameTrack& track, double time, const MfaStubParams& params);

}  // namespace esa_frame_builder
