#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <cstdint>
#include <set>
#include <string>

#include "drawing.h"

namespace tws_rviz {

/// Turns the pictures of one layer into marker arrays for one topic: all triangles are one marker, each label another
/// one.
class MarkerLayer {
 public:
  /// `height` [m] orders the layers: a higher one covers a lower one. It must stay below 500, where RViz's eye is.
  MarkerLayer(std::string frame, std::string name, double height);

  /// What makes RViz show `drawing` instead of the picture before it. The first array also removes what an earlier run
  /// left.
  visualization_msgs::MarkerArray show(const Drawing& drawing, ros::Time time);

 private:
  visualization_msgs::Marker marker(const std::string& part, int id, int type, ros::Time time) const;
  visualization_msgs::Marker triangles(const Drawing& drawing, ros::Time time) const;
  visualization_msgs::Marker text(const Label& label, ros::Time time) const;

  std::string frame_;
  std::string name_;
  double height_;
  bool started_ = false;
  std::set<std::uint32_t> labels_;  // now on the screen
};

}  // namespace tws_rviz
