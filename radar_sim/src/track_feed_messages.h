#pragma once

#include <string>
#include <vector>

#include <tws_core/sea_level.h>
#include <tws_msgs/Tracks.h>

#include "track_feed.h"

namespace radar_sim {

/// The message of one sector of the clock radar, in a map over this sea; all its tracks are firm. Leaves `sequence` to
/// the caller.
tws_msgs::Tracks toTracks(const TrackFeed& feed, const std::vector<FedTrack>& tracks, const tws::RadarSector& sector,
                          const std::vector<Target>& targets, const tws::SeaLevel& sea);

/// "primary" or "secondary": the tracks come on /primary/tracks or /secondary/tracks.
std::string nameOf(FeedKind kind);

}  // namespace radar_sim
