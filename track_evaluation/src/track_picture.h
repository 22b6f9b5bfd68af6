#pragma once

#include <tws_msgs/CorrelatedTracks.h>
#include <tws_msgs/Tracks.h>

#include <map>
#include <string>
#include <vector>

#include "epoch.h"

namespace track_evaluation {

/// Why a track's message cannot be used, e.g. "position.x is nan"; empty: it can.
std::string faultOf(const tws_msgs::Track& track);

/// The same without what only a correlator says: the tracks under their own identities.
tws_msgs::Tracks tracksOf(const tws_msgs::CorrelatedTracks& message);

/// The whole picture of one tracker: the latest update of each track.
class TrackPicture {
 public:
  /// A track without an update for longer than `longest_silence` [s] is no longer shown.
  explicit TrackPicture(double longest_silence) : longest_silence_(longest_silence) {}

  /// Takes what has no fault.
  void add(const tws_msgs::Tracks& message);
  /// The confirmed tracks (firm or coasting) at `time` [s], moved on by their velocities, in the order of their uid.
  std::vector<TrackState> at(double time) const;

 private:
  double longest_silence_;
  std::map<std::uint32_t, tws_msgs::Track> updates_;
};

}  // namespace track_evaluation
