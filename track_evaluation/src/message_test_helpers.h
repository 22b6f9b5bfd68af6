#pragma once

#include <tws_msgs/Tracks.h>
#include <tws_msgs/Truth.h>

#include <limits>

namespace track_evaluation {

/// A firm track without height, detected and stated at `time` [s].
inline tws_msgs::Track firmTrack(std::uint32_t uid, double time, double x, double y, double vx = 0.0) {
  tws_msgs::Track track;
  track.uid = uid;
  track.state = tws_msgs::Track::FIRM;
  track.stamp = track.last_update = ros::Time(time);
  track.position.x = x;
  track.position.y = y;
  track.position.z = std::numeric_limits<double>::quiet_NaN();
  track.velocity.x = vx;
  track.mode_3a = tws_msgs::Track::CODE_UNKNOWN;
  track.height = std::numeric_limits<double>::quiet_NaN();
  return track;
}

inline tws_msgs::Tracks tracksAt(double time, std::vector<tws_msgs::Track> tracks) {
  tws_msgs::Tracks message;
  message.header.stamp = ros::Time(time);
  message.header.frame_id = "map";
  message.tracker = "adit";
  message.radar = "a";
  message.tracks = std::move(tracks);
  return message;
}

inline tws_msgs::TruthTarget aircraft(std::uint32_t id, double x, double y, double z = 0.0, double chance = 1.0) {
  tws_msgs::TruthTarget target;
  target.id = id;
  target.kind = tws_msgs::TruthTarget::AIRCRAFT;
  target.position.x = x;
  target.position.y = y;
  target.position.z = z;
  target.mode_3a = 65535;
  target.detection_probability = {0.0, chance};
  return target;
}

inline tws_msgs::Truth truthMessage(double time, std::vector<tws_msgs::TruthTarget> targets) {
  tws_msgs::Truth message;
  message.header.stamp = ros::Time(time);
  message.header.frame_id = "map";
  message.targets = std::move(targets);
  return message;
}

}  // namespace track_evaluation
