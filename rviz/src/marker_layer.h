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
  /// left. A picture with a `time` of its own vanishes when no other one follows it for ten seconds of data time, or
  /// ten times as long as it came after the one before (at high rates data time runs far between two pictures); one
  /// with time 0 stays.
  visualization_msgs::MarkerArray show(const Drawing& drawing, ros::Time time);

 private:
  void updateLifetime(ros::Time time);
  visualization_msgs::Marker marker(const std::string& part, int id, int type) const;
  visualization_msgs::Marker triangles(const Drawing& drawing) const;
  visualization_msgs::Marker text(const Label& label) const;

  std::string frame_;
  std::string name_;
  double height_;
  bool started_ = false;
  ros::Time time_;                  // of the picture
  double lifetime_ = 0.0;           // [s]
  std::set<std::uint32_t> labels_;  // now on the screen
};

}  // namespace tws_rviz
