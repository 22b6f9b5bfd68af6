#include "marker_layer.h"

#include <tws_runtime/conversions.h>

#include <algorithm>
#include <utility>

namespace tws_rviz {
namespace {

using tws_runtime::secondsBetween;
using visualization_msgs::Marker;

constexpr double kLeastLifetime = 10.0, kGreatestLifetime = 3600.0;  // [s]

std_msgs::ColorRGBA toMessage(const Rgba& color) {
  std_msgs::ColorRGBA message;
  message.r = color.r;
  message.g = color.g;
  message.b = color.b;
  message.a = color.a;
  return message;
}

geometry_msgs::Point toMessage(const Eigen::Vector2d& position) {
  geometry_msgs::Point message;
  message.x = position.x();
  message.y = position.y();
  return message;
}

}  // namespace

MarkerLayer::MarkerLayer(std::string frame, std::string name, double height)
    : frame_(std::move(frame)), name_(std::move(name)), height_(height) {}

visualization_msgs::MarkerArray MarkerLayer::show(const Drawing& drawing, ros::Time time) {
  updateLifetime(time);
  visualization_msgs::MarkerArray array;
  if (!std::exchange(started_, true)) {
    array.markers.push_back(marker("", 0, Marker::TRIANGLE_LIST));
    array.markers.back().action = Marker::DELETEALL;
  }
  array.markers.push_back(triangles(drawing));
  std::set<std::uint32_t> vanished = std::exchange(labels_, {});
  for (const Label& label : drawing.labels) {
    array.markers.push_back(text(label));
    labels_.insert(label.id);
    vanished.erase(label.id);
  }
  for (const std::uint32_t id : vanished) {
    array.markers.push_back(marker(name_ + " labels", static_cast<int>(id), Marker::TEXT_VIEW_FACING));
    array.markers.back().action = Marker::DELETE;
  }
  return array;
}

void MarkerLayer::updateLifetime(ros::Time time) {
  const bool goes_on = !time_.isZero() && time >= time_;
  // The steps differ; a short one must not make the picture flicker.
  if (!time.isZero())
    lifetime_ =
        goes_on ? std::max(kLeastLifetime,
                           std::min(kGreatestLifetime, std::max(10.0 * secondsBetween(time_, time), 0.9 * lifetime_)))
                : kLeastLifetime;
  time_ = time;
}

Marker MarkerLayer::marker(const std::string& part, int id, int type) const {
  Marker marker;
  marker.header.frame_id = frame_;
  marker.header.stamp = time_;
  marker.lifetime = ros::Duration(lifetime_);
  marker.ns = part;
  marker.id = id;
  marker.type = type;
  marker.pose.position.z = height_;
  marker.pose.orientation.w = 1.0;
  marker.scale.x = marker.scale.y = marker.scale.z = 1.0;
  marker.color.a = 1.0f;
  return marker;
}

Marker MarkerLayer::triangles(const Drawing& drawing) const {
  Marker result = marker(name_, 0, Marker::TRIANGLE_LIST);
  // RViz calls an empty list an error.
  if (drawing.triangles.empty()) result.action = Marker::DELETE;
  result.points.reserve(drawing.triangles.size());
  result.colors.reserve(drawing.triangles.size());
  for (const Vertex& vertex : drawing.triangles) {
    result.points.push_back(toMessage(vertex.position));
    result.colors.push_back(toMessage(vertex.color));
  }
  return result;
}

Marker MarkerLayer::text(const Label& label) const {
  Marker result = marker(name_ + " labels", static_cast<int>(label.id), Marker::TEXT_VIEW_FACING);
  result.pose.position.x = label.centre.x();
  result.pose.position.y = label.centre.y();
  result.scale.z = label.height;
  result.color = toMessage(label.color);
  result.text = label.text;
  return result;
}

}  // namespace tws_rviz
