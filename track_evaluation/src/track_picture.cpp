#include "track_picture.h"

#include <tws_runtime/conversions.h>

#include <cmath>

namespace track_evaluation {
namespace {

using tws_msgs::Track;

/// x, y, vx, vy moved on by `age` [s]; without process noise.
std::optional<Eigen::Matrix4d> covarianceOf(const Track& track, double age) {
  if (track.covariance.size() != 16) return std::nullopt;
  const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> stated(track.covariance.data());
  if (!stated.allFinite()) return std::nullopt;
  Eigen::Matrix4d motion = Eigen::Matrix4d::Identity();
  motion(0, 2) = motion(1, 3) = age;
  return Eigen::Matrix4d(motion * stated * motion.transpose());
}

TrackState stateOf(const Track& track, double time) {
  TrackState state;
  state.id = track.uid;
  state.age = time - tws_runtime::toSeconds(track.stamp);
  state.state.velocity = {track.velocity.x, track.velocity.y};
  state.state.position = Eigen::Vector2d(track.position.x, track.position.y) + state.age * state.state.velocity;
  state.has_height = !std::isnan(track.position.z);
  state.last_update = tws_runtime::toSeconds(track.last_update);
  state.covariance = covarianceOf(track, state.age);
  state.mode_3a = track.mode_3a;
  state.height = track.height;
  return state;
}

}  // namespace

std::string faultOf(const Track& track) {
  const std::pair<const char*, double> numbers[] = {{"position.x", track.position.x}, {"position.y", track.position.y},
                                                    {"velocity.x", track.velocity.x}, {"velocity.y", track.velocity.y},
                                                    {"range", track.range},           {"azimuth", track.azimuth}};
  for (const auto& [name, value] : numbers)
    if (!std::isfinite(value)) return std::string(name) + " is " + std::to_string(value);
  if (track.state < Track::TENTATIVE || track.state > Track::DROPPED) return "state is " + std::to_string(track.state);
  return "";
}

tws_msgs::Tracks tracksOf(const tws_msgs::CorrelatedTracks& message) {
  tws_msgs::Tracks tracks;
  tracks.header = message.header;
  tracks.radar = message.radar;
  tracks.sector = message.sector;
  tracks.running_sector = message.running_sector;
  for (const tws_msgs::CorrelatedTrack& track : message.tracks) {
    tracks.tracks.push_back(track.track);
    tracks.tracks.back().uid = tracks.tracks.back().number = track.identity;
  }
  return tracks;
}

void TrackPicture::add(const tws_msgs::Tracks& message) {
  for (const Track& track : message.tracks) {
    if (track.state == Track::DROPPED)
      updates_.erase(track.uid);
    else if (faultOf(track).empty())
      updates_[track.uid] = track;
  }
}

std::vector<TrackState> TrackPicture::at(double time) const {
  std::vector<TrackState> tracks;
  for (const auto& [uid, track] : updates_) {
    const bool confirmed = track.state == Track::FIRM || track.state == Track::COASTING;
    if (confirmed && time - tws_runtime::toSeconds(track.stamp) <= longest_silence_)
      tracks.push_back(stateOf(track, time));
  }
  return tracks;
}

}  // namespace track_evaluation
