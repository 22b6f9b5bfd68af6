#pragma once

#include <Eigen/Core>
#include <deque>

#include "drawing.h"

namespace tws_rviz {

/// One detection on the screen.
struct PlotMark {
  double time = 0.0;         // data time of the detection [s]
  Eigen::Vector2d position;  // [m]
  double azimuth = 0.0;      // in which the radar saw it [rad]; the plot lies across
};

/// The latest detections of one radar, which fade as the phosphor of a PPI does.
class FadingDetections {
 public:
  /// Forgets what has faded `persistence` [s] before this one.
  void add(const PlotMark& plot, double persistence);

  /// Each plot `size` [m] long; full colour when new, nothing `persistence` [s] later.
  void draw(Drawing& drawing, double time, double persistence, double size, const Rgba& color) const;

  std::size_t size() const { return plots_.size(); }

 private:
  std::deque<PlotMark> plots_;  // in order of arrival
};

}  // namespace tws_rviz
