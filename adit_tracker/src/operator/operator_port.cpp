#include "operator/operator_port.h"

#include <tf2/LinearMath/Transform.h>
#include <tf2/exceptions.h>

#include <algorithm>
#include <cmath>

#include "operator/operator_messages.h"

namespace adit_tracker {
namespace {

using Request = tws_msgs::OperatorRequest;

TrackWord wordOn(const Adit& adit, TrackFile::Slot slot) {
  const bool coasting = adit.tracks().at(slot).coasting;
  return {slot, coasting ? TrackEvent::kCoasted : TrackEvent::kUpdated, adit.tracks().latest().enter_time};
}

tf2::Transform transformOf(const geometry_msgs::Transform& t) {
  return tf2::Transform(tf2::Quaternion(t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w),
                        tf2::Vector3(t.translation.x, t.translation.y, t.translation.z));
}

}  // namespace

OperatorPort::OperatorPort(tws_runtime::Bus& bus, const std::string& frame, const std::string& point_topic, Host host)
    : bus_(bus), frame_(frame), host_(std::move(host)), told_(bus.advertise<Request>("~operator_requests")) {
  bus.serve<tws_msgs::OperatorCommand>("~operator_command",
                                       [this](auto& request, auto& response) { return command(request, response); });
  bus.serve<tws_msgs::InitiateTrack>("~initiate_track",
                                     [this](auto& request, auto& response) { return initiate(request, response); });
  bus.serve<tws_msgs::DropTrack>("~drop_track",
                                 [this](auto& request, auto& response) { return drop(request, response); });
  bus.subscribe<Request>("~recorded_requests", [this](const Request& message) { hearRecorded(message); });
  if (point_topic.empty()) return;
  bus.subscribe<geometry_msgs::PointStamped>(point_topic, [this](const auto& point) { hearPoint(point); });
}

Request OperatorPort::blank(std::uint8_t request) const {
  Request message;
  message.header.frame_id = frame_;
  message.tracker = bus_.name();
  message.request = request;
  message.run = run_;
  message.lower = message.upper = OperatorRequest::kUnused;
  return message;
}

/// The tracker, when it has time for the operator; else the message says so, to all.
Adit* OperatorPort::readyFor(Request& message) {
  Adit* const adit = host_.caught_up(message.message);
  if (adit != nullptr) return adit;
  message.header.stamp = bus_.now();
  message.result = Request::BUSY;
  message.message = "busy: " + message.message;
  told_.publish(message);
  return nullptr;
}

OperatorAnswer OperatorPort::carryOutAndTell(Adit& adit, Request& message) {
  const OperatorAnswer answer = carryOut(adit, requestOf(message, host_.site()));
  setEffect(message, adit, answer);
  told_.publish(message);
  return answer;
}

void OperatorPort::order(Message& message, const std::string& refusal) {
  Adit* const adit = readyFor(message);
  if (adit == nullptr) return;
  if (refusal.empty())
    carryOutAndTell(*adit, message);
  else
    tellRefusal(*adit, message, refusal);
}

void OperatorPort::tellRefusal(const Adit& adit, Message& message, const std::string& refusal) {
  OperatorAnswer answer;
  answer.refusal = refusal;
  setEffect(message, adit, answer);
  told_.publish(message);
}

bool OperatorPort::command(const tws_msgs::OperatorCommand::Request& request,
                           tws_msgs::OperatorCommand::Response& response) {
  Request message = blank(request.request);
  message.track = request.track;
  message.cancel = request.cancel;
  message.lower = request.lower;
  message.upper = request.upper;
  message.start = request.start;
  message.position.x = message.position.y = OperatorRequest::kUnused;  // INITIATE has a service of its own
  if (Adit* const adit = readyFor(message)) {
    const OperatorAnswer answer = carryOutAndTell(*adit, message);
    response.next = answer.next;
    for (const auto slot : answer.tracks)
      response.tracks.push_back(trackMessage(*adit, wordOn(*adit, slot), host_.site()));
  }
  response.result = message.result;
  response.message = message.message;
  response.count = message.count;
  return true;
}

/// The request to start a track there; `why` not, when the point's frame is unknown.
Request OperatorPort::pointRequest(const geometry_msgs::PointStamped& point, std::string& why) const {
  Request message = blank(Request::INITIATE);
  const std::string& frame = point.header.frame_id.empty() ? frame_ : point.header.frame_id;
  try {
    const auto transform = bus_.transforms().lookupTransform(frame_, frame, ros::Time());
    const tf2::Vector3 there =
        transformOf(transform.transform) * tf2::Vector3(point.point.x, point.point.y, point.point.z);
    message.position.x = there.x();
    message.position.y = there.y();
    message.position.z = there.z();
  } catch (const tf2::TransformException& error) {
    why = "the point's frame is unknown: " + std::string(error.what());
  }
  return message;
}

bool OperatorPort::initiate(const tws_msgs::InitiateTrack::Request& request,
                            tws_msgs::InitiateTrack::Response& response) {
  Request message = pointRequest(request.point, response.message);
  if (!response.message.empty()) return true;
  if (Adit* const adit = readyFor(message)) carryOutAndTell(*adit, message);
  response.success = message.result == Request::OK;
  response.message = message.message;
  if (response.success) response.number = message.tracks.front();
  return true;
}

bool OperatorPort::drop(const tws_msgs::DropTrack::Request& request, tws_msgs::DropTrack::Response& response) {
  std::vector<Request> messages(std::max<std::size_t>(request.numbers.size(), 1),
                                blank(request.numbers.empty() ? Request::DROP_ALL : Request::DROP));
  response.success = true;
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (!request.numbers.empty()) messages[i].track = request.numbers[i];
    if (Adit* const adit = readyFor(messages[i])) carryOutAndTell(*adit, messages[i]);
    if (messages[i].result == Request::OK) continue;
    response.message += (response.success ? "" : "; ") + messages[i].message;
    response.success = false;
  }
  return true;
}

void OperatorPort::hearPoint(const geometry_msgs::PointStamped& point) {
  tws_msgs::InitiateTrack::Request request;
  tws_msgs::InitiateTrack::Response response;
  request.point = point;
  initiate(request, response);
  if (!response.success) bus_.counter("refused points").add(response.message);
}

void OperatorPort::hearRecorded(const Request& message) {
  if (message.result != Request::BUSY) recorded_.push_back(message);
}

void OperatorPort::beforeSector(Adit& adit) {
  if (adit.counts().sectors > 0) return;
  const auto at_start = [&](const Request& m) { return m.radar.empty() && m.run == run_; };
  for (auto found = recorded_.begin();
       (found = std::find_if(recorded_.begin(), recorded_.end(), at_start)) != recorded_.end();
       recorded_.erase(found)) {
    // The file that was loaded when this was recorded may have been given once more.
    const auto same = [&](const Request& done) { return done.clutter == found->clutter; };
    if (std::any_of(at_start_.begin(), at_start_.end(), same)) continue;
    const OperatorAnswer answer = carryOut(adit, requestOf(*found, tws_runtime::Site{}));
    at_start_.push_back(*found);
    setEffect(at_start_.back(), adit, answer);
  }
}

void OperatorPort::afterSector(Adit& adit) {
  for (Request& message : at_start_) {
    message.header.seq = 0;
    message.header.stamp = tws_runtime::toTime(adit.tracks().latest().enter_time);
    message.radar.clear();
    message.running_sector = 0;
    told_.publish(message);
  }
  at_start_.clear();
  const auto& radars = adit.params().radars;
  const auto due = [&](const Request& m) {
    if (m.radar.empty()) return m.run == run_;  // it should have been here before the first sector
    for (std::size_t i = 0; i < radars.size(); ++i) {
      const auto passed =
          static_cast<std::int32_t>(static_cast<std::uint32_t>(adit.order().front(i)) - m.running_sector);
      if (radars[i].name == m.radar) return m.run == run_ && passed > 0;
    }
    return false;
  };
  for (auto found = recorded_.begin();
       (found = std::find_if(recorded_.begin(), recorded_.end(), due)) != recorded_.end();) {
    const Request recorded = *found;
    recorded_.erase(found);
    repeat(adit, recorded);
  }
}

void OperatorPort::repeat(Adit& adit, const Request& recorded) {
  Request message = recorded;
  message.header.seq = 0;
  // A file that could not be loaded is not here to be tried again.
  if (recorded.request == Request::LOAD_CLUTTER && recorded.result == Request::REFUSED)
    tellRefusal(adit, message, recorded.message);
  else
    carryOutAndTell(adit, message);
  if (message.radar != recorded.radar || message.running_sector != recorded.running_sector)
    bus_.counter("late recorded requests").add("request " + std::to_string(message.request) + " came too late");
  else if (!sameEffect(message, recorded))
    bus_.counter("requests repeated with another effect").add("request " + std::to_string(message.request));
}

}  // namespace adit_tracker
