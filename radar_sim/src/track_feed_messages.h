#pragma once

#include <string>
#include <vector>

#include <tws_msgs/Tracks.h>

#include "track_feed.h"

namespace radar_sim {

/// The message of one sector of the clock radar, whose antenna is so high above the sea [m]; all its tracks are firm.
/// Leaves `sequence` to the caller.
tws_msgs::Tracks toTracks(const TrackFeed& feed, const std::vector<FedTrack>& tracks, const tws::RadarSector& sector,
                          const std::vector<Target>& targets, double antenna_height);

/// "primary" or "secondary": the tracks come on /primary/tracks or /secondary/tracks.
std::string nameOf(FeedKind kind);

}  // namespace radar_sim
