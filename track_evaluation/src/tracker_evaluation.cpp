#include "tracker_evaluation.h"

#include <tws_core/geometry.h>
#include <tws_runtime/conversions.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace track_evaluation {
namespace {

// Tracks come first: what was said at the very instant of an epoch counts.
constexpr std::size_t kTracks = 0, kTruth = 1;

CorrelationMetrics::Kind kindOf(const tws_msgs::CorrelatedTrack& track) {
  if (track.kind == tws_msgs::CorrelatedTrack::CORRELATED) return CorrelationMetrics::Kind::kCorrelated;
  return track.kind == tws_msgs::CorrelatedTrack::SECONDARY_ONLY ? CorrelationMetrics::Kind::kSecondaryOnly
                                                                 : CorrelationMetrics::Kind::kPrimaryOnly;
}

}  // namespace

TrackerEvaluation::TrackerEvaluation(const EvaluationParams& params, FindSite find_site, OnEpoch on_epoch,
                                     OnUpdate on_update)
    : identity(params.identity),
      params_(params),
      find_site_(std::move(find_site)),
      on_epoch_(std::move(on_epoch)),
      on_update_(std::move(on_update)),
      order_(2, params.skew_limit),
      picture_(params.longest_silence) {}

bool TrackerEvaluation::add(const tws_msgs::Truth& message) {
  const bool in_time = !order_.push(kTruth, tws_runtime::toSeconds(message.header.stamp), Input(message));
  drain();
  return in_time;
}

bool TrackerEvaluation::add(const tws_msgs::Tracks& message) { return addTracks(message); }

bool TrackerEvaluation::add(const tws_msgs::CorrelatedTracks& message) { return addTracks(message); }

template <class M>
bool TrackerEvaluation::addTracks(const M& message) {
  const bool in_time = !order_.push(kTracks, tws_runtime::toSeconds(message.header.stamp), Input(message));
  if (!in_time) take(message);
  drain();
  return in_time;
}

void TrackerEvaluation::finish() {
  order_.flush();
  drain();
}

void TrackerEvaluation::drain() {
  while (const auto item = order_.pop()) std::visit([this](const auto& message) { take(message); }, item->value);
}

void TrackerEvaluation::take(const tws_msgs::Tracks& message) {
  radar_ = message.radar;
  picture_.add(message);
  addUpdates(message);
}

void TrackerEvaluation::take(const tws_msgs::CorrelatedTracks& message) {
  take(tracksOf(message));
  for (const tws_msgs::CorrelatedTrack& track : message.tracks)
    if (track.track.state != tws_msgs::Track::DROPPED)
      correlation.add({track.identity, kindOf(track), track.track.mode_3a});
}

void TrackerEvaluation::addUpdates(const tws_msgs::Tracks& message) {
  for (const tws_msgs::Track& track : message.tracks) {
    if (track.state == tws_msgs::Track::DROPPED) last_update_.erase(track.uid);
    if (track.state != tws_msgs::Track::FIRM) continue;
    const double update = tws_runtime::toSeconds(track.last_update);
    double& known = last_update_[track.uid];
    if (update <= known || !faultOf(track).empty()) continue;
    known = update;
    identity.addUpdate(update, track.uid, tws::planarFromPolar(track.range, track.azimuth));
    if (!evaluator_) on_update_(track);
  }
}

// A tracker of a radar that does not rotate is asked for what that radar covers, all others for what the rotating ones
// do.
TruthFilter TrackerEvaluation::filter() const {
  TruthFilter filter = params_.filter;
  filter.radars = params_.radars;
  const auto& arrays = params_.array_radars;
  if (std::find(arrays.begin(), arrays.end(), radar_) != arrays.end()) filter.radars = {radar_};
  return filter;
}

Eigen::Vector3d TrackerEvaluation::siteOf(const tws_msgs::Truth& message) {
  Eigen::Vector3d site = find_site_(radar_, message.header.frame_id);
  if (!radar_.empty()) sites_[radar_] = site;
  return site;
}

// Who joins radars at several sites cannot lay the slant range of one of them on the plane: such tracks are meant as
// places on the ground.
bool TrackerEvaluation::isOnGround() const {
  constexpr double kSameSite = 100.0;  // [m]
  return std::any_of(sites_.begin(), sites_.end(), [&](const std::pair<const std::string, Eigen::Vector3d>& site) {
    return std::hypot(site.second.x() - sites_.begin()->second.x(), site.second.y() - sites_.begin()->second.y()) >
           kSameSite;
  });
}

void TrackerEvaluation::take(const tws_msgs::Truth& message) {
  Epoch epoch;
  epoch.time = tws_runtime::toSeconds(message.header.stamp);
  epoch.truths = truthsOf(message, siteOf(message), filter());
  epoch.tracks = picture_.at(epoch.time);
  for (auto& track : epoch.tracks) track.has_height = track.has_height || isOnGround();
  if (!evaluator_) {
    EvaluatorParams params = params_.evaluator;
    params.from += epoch.time;
    evaluator_.emplace(params, params_.profiles);
  }
  try {
    evaluator_->add(epoch);
  } catch (const std::invalid_argument&) {
    return;  // A second message of one instant.
  }
  ++epochs_;
  correlation.judge(epoch, evaluator_->lastPairs());
  on_epoch_(epoch, *evaluator_);
}

}  // namespace track_evaluation
