#include "operator/operator_messages.h"

#include <cmath>

namespace adit_tracker {

OperatorRequest requestOf(const tws_msgs::OperatorRequest& message, const tws_runtime::Site& site) {
  OperatorRequest request;
  request.action = static_cast<OperatorAction>(message.request);
  request.track = message.track;
  request.cancel = message.cancel != 0;
  request.from = message.lower;
  request.to = message.upper;
  request.start = message.start;
  const double c = std::cos(site.turn), s = std::sin(site.turn);
  const double dx = message.position.x - site.x, dy = message.position.y - site.y;
  request.x = c * dx + s * dy;
  request.y = c * dy - s * dx;
  for (const tws_msgs::ClutterPoint& p : message.clutter) request.clutter.push_back({p.radar, p.range, p.azimuth});
  return request;
}

std::vector<tws_msgs::ClutterPoint> clutterPoints(const std::vector<ClutterPlace>& places) {
  std::vector<tws_msgs::ClutterPoint> points;
  for (const ClutterPlace& place : places) {
    tws_msgs::ClutterPoint& point = points.emplace_back();
    point.radar = place.radar;
    point.range = place.range;
    point.azimuth = place.azimuth;
  }
  return points;
}

void setEffect(tws_msgs::OperatorRequest& message, const Adit& adit, const OperatorAnswer& answer) {
  message.result = answer.refusal.empty() ? tws_msgs::OperatorRequest::OK : tws_msgs::OperatorRequest::REFUSED;
  message.message = answer.refusal;
  message.count = answer.count;
  message.tracks.clear();
  for (const TrackFile::Slot slot : answer.tracks) message.tracks.push_back(adit.tracks().at(slot).number);
}

}  // namespace adit_tracker
