#pragma once

#include <tws_runtime/bus.h>
#include <visualization_msgs/MarkerArray.h>

#include <string>

#include "marker_layer.h"

namespace tws_rviz {

/// A layer of a picture and the topic on which it goes out.
class Screen {
 public:
  /// The topic is /<picture>/<name>.
  Screen(tws_runtime::Bus& bus, const std::string& frame, const std::string& picture, const std::string& name,
         double height, bool latched = false)
      : layer_(frame, name, height),
        publisher_(bus.advertise<visualization_msgs::MarkerArray>(picture + "/" + name, latched)) {}
  void show(const Drawing& drawing, ros::Time time) { publisher_.publish(layer_.show(drawing, time)); }

 private:
  MarkerLayer layer_;
  tws_runtime::Publisher<visualization_msgs::MarkerArray> publisher_;
};

}  // namespace tws_rviz
