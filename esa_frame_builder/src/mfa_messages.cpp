#include "mfa_messages.h"

#include <tws_msgs/Track.h>
#include <tws_runtime/conversions.h>

#include <cmath>
#include <limits>

#include <tws_core/geometry.h>

namespace esa_frame_builder {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

std::uint8_t stateOf(const TrackWord& word) {
  using tws_msgs::Track;
  if (word.dropped) return Track::DROPPED;
  if (word.track.stage == TrackStage::kTentative) return Track::TENTATIVE;
  return word.seen == FrameCase::kMissed ? Track::COASTING : Track::FIRM;
}

void setMotion(tws_msgs::Track& message, const tws::SpatialState& state, const ArrayPose& pose) {
  const Eigen::Vector3d place = state.mean.head<3>(), velocity = state.mean.tail<3>();
  const tws::Polar polar = tws::polarFromEnu(place - pose.place);
  const tws::PolarRates rates = tws::polarRates(place - pose.place, velocity);
  message.range = polar.range;
  message.azimuth = polar.azimuth;
  message.elevation = polar.elevation;
  message.range_rate = rates.range;
  message.azimuth_rate = rates.azimuth;
  message.position.x = place.x();
  message.position.y = place.y();
  message.position.z = message.height = place.z();
  message.height_sigma = kUnknown;
  message.velocity.x = velocity.x();
  message.velocity.y = velocity.y();
  message.velocity.z = velocity.z();
  message.speed = velocity.head<2>().norm();
  message.course = message.speed > 0.0 ? tws::azimuthOf(velocity.head<2>()) : kUnknown;
  for (const int row : {0, 1, 3, 4})
    for (const int column : {0, 1, 3, 4}) message.covariance.push_back(state.covariance(row, column));
}

}  // namespace

tws_msgs::Track trackMessage(const TrackWord& word, const ArrayPose& pose, const std::string& radar) {
  using tws_msgs::Track;
  tws_msgs::Track message;
  message.number = message.uid = word.track.number;
  message.state = stateOf(word);
  message.stamp = tws_runtime::toTime(word.track.time);
  message.first_detection = tws_runtime::toTime(word.track.first_detection);
  message.last_update = tws_runtime::toTime(word.track.last_update);
  setMotion(message, word.track.state, pose);
  message.detection_bits = word.seen == FrameCase::kSeen ? Track::DETECTED_BY_RADAR_0 : 0;
  message.radars = {radar};
  message.radar_updates = {message.last_update};
  message.mode_1 = message.mode_2 = message.mode_3a = Track::CODE_UNKNOWN;
  return message;
}

tws_msgs::TrackDatabaseEntry databaseEntry(const FrameTrack& track, double time, const MfaStubParams& params) {
  tws::SpatialState state = track.state;
  const double moved_to = std::max(time, track.time);
  tws::predict(state, moved_to - track.time, params.acceleration_density);
  tws_msgs::TrackDatabaseEntry entry;
  entry.number = track.number;
  entry.stamp = tws_runtime::toTime(moved_to);
  entry.last_update = tws_runtime::toTime(track.last_update);
  entry.position.x = state.mean[0];
  entry.position.y = state.mean[1];
  entry.position.z = state.mean[2];
  entry.velocity.x = state.mean[3];
  entry.velocity.y = state.mean[4];
  entry.velocity.z = state.mean[5];
  entry.covariance.assign(state.covariance.data(), state.covariance.data() + 36);  // symmetric: rows are columns
  const bool firm = track.stage == TrackStage::kFirm;
  entry.priority = firm ? 1 : 2;
  entry.revisit_interval = firm ? params.firm_revisit : params.tentative_revisit;
  return entry;
}

}  // namespace esa_frame_builder
