#include "mfa_messages.h"

#include <tws_msgs/Track.h>
#include <tws_runtime/conversions.h>
#include <tws_runtime/track_writer.h>

#include <algorithm>

namespace esa_frame_builder {
namespace {

std::uint8_t stateOf(const TrackUpdate& update) {
  using tws_msgs::Track;
  if (update.dropped) return Track::DROPPED;
  if (update.track.stage == TrackStage::kTentative) return Track::TENTATIVE;
  return update.seen == FrameCase::kMissed ? Track::COASTING : Track::FIRM;
}

}  // namespace

tws_msgs::Track trackMessage(const TrackUpdate& update, const Eigen::Vector3d& array, const tws::SeaLevel& sea,
                             const std::string& radar) {
  using tws_msgs::Track;
  Track message = tws_runtime::blankTrack(update.track.number, update.track.number);
  message.state = stateOf(update);
  message.stamp = tws_runtime::toTime(update.track.time);
  message.first_detection = tws_runtime::toTime(update.track.first_detection);
  message.last_update = tws_runtime::toTime(update.track.last_update);
  tws_runtime::setSpatial(message, update.track.state, array, sea);
  message.detection_bits = update.seen == FrameCase::kSeen ? Track::DETECTED_BY_RADAR_0 : 0;
  message.radars = {radar};
  message.radar_updates = {message.last_update};
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
