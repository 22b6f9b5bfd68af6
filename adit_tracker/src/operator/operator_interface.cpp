#include "operator/operator_interface.h"

#include <tf2/LinearMath/Transform.h>
#include <tf2/exceptions.h>

#include <algorithm>

#include "operator/operator_messages.h"

namespace adit_tracker {
namespace {

using Message = OperatorInterface::Message;

tf2::Transform transformOf(const geometry_msgs::Transform& t) {
  return tf2::Transform(tf2::Quaternion(t.rotation.x, t.rotation.y, t.rotation.z, t.rotation.w),
                        tf2::Vector3(t.translation.x, t.translation.y, t.translation.z));
}

}  // namespace

OperatorInterface::OperatorInterface(tws_runtime::Bus& bus, const std::string& frame, const std::string& point_topic,
                                     Host host)
    : bus_(bus), frame_(frame), host_(std::move(host)), log_(bus, frame), handler_(log_) {
  bus.serve<tws_msgs::OperatorCommand>("~operator_command",
                                       [this](auto& request, auto& response) { return onCommand(request, response); });
  bus.serve<tws_msgs::InitiateTrack>("~initiate_track",
                                     [this](auto& request, auto& response) { return onInitiate(request, response); });
  bus.serve<tws_msgs::DropTrack>("~drop_track",
                                 [this](auto& request, auto& response) { return onDrop(request, response); });
  if (point_topic.empty()) return;
  bus.subscribe<geometry_msgs::PointStamped>(point_topic, [this](const auto& point) { onPoint(point); });
}

void OperatorInterface::publish(const std::vector<Message>& messages) {
  for (const Message& message : messages) log_.publish(message);
}

/// Has all requests executed that wait. No request is in work while the tracker catches up: what comes meanwhile, or is
/// repeated then, does not come between.
void OperatorInterface::serve() {
  std::string why;
  Adit* const adit = host_.catch_up(why);
  publish(adit != nullptr ? handler_.execute(*adit, host_.site()) : handler_.refuse("busy: " + why, bus_.now()));
}

OperatorOutcome OperatorInterface::ask(const Message& message, const std::string& refusal) {
  const auto ticket = handler_.add(message, refusal);
  serve();
  return *handler_.take(ticket);
}

bool OperatorInterface::onCommand(const tws_msgs::OperatorCommand::Request& request,
                                  tws_msgs::OperatorCommand::Response& response) {
  Message message = blank(request.request);
  message.track = request.track;
  message.cancel = request.cancel;
  message.lower = request.lower;
  message.upper = request.upper;
  message.start = request.start;
  message.position.x = message.position.y = OperatorRequest::kUnused;  // INITIATE has a service of its own
  const OperatorOutcome outcome = ask(message);
  response.next = outcome.next;
  response.tracks = outcome.tracks;
  response.result = outcome.message.result;
  response.message = outcome.message.message;
  response.count = outcome.message.count;
  return true;
}

/// The request to start a track there; `why` not, when the point's frame is unknown.
Message OperatorInterface::pointRequest(const geometry_msgs::PointStamped& point, std::string& why) const {
  Message message = blank(Message::INITIATE);
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

bool OperatorInterface::onInitiate(const tws_msgs::InitiateTrack::Request& request,
                                   tws_msgs::InitiateTrack::Response& response) {
  const Message message = pointRequest(request.point, response.message);
  if (!response.message.empty()) return true;
  const Message answer = ask(message).message;
  response.success = answer.result == Message::OK;
  response.message = answer.message;
  if (response.success) response.number = answer.tracks.front();
  return true;
}

/// All of them between the same two sectors.
bool OperatorInterface::onDrop(const tws_msgs::DropTrack::Request& request, tws_msgs::DropTrack::Response& response) {
  std::vector<OperatorHandler::Ticket> tickets;
  if (request.numbers.empty()) tickets.push_back(handler_.add(blank(Message::DROP_ALL)));
  for (const std::uint32_t number : request.numbers) {
    Message message = blank(Message::DROP);
    message.track = number;
    tickets.push_back(handler_.add(message));
  }
  serve();
  response.success = true;
  for (const auto ticket : tickets) {
    const Message answer = handler_.take(ticket)->message;
    if (answer.result == Message::OK) continue;
    response.message += (response.success ? "" : "; ") + answer.message;
    response.success = false;
  }
  return true;
}

void OperatorInterface::onPoint(const geometry_msgs::PointStamped& point) {
  tws_msgs::InitiateTrack::Request request;
  tws_msgs::InitiateTrack::Response response;
  request.point = point;
  onInitiate(request, response);
  if (!response.success) bus_.counter("refused points").add(response.message);
}

}  // namespace adit_tracker
