#include "fading_detections.h"

namespace tws_rviz {

void FadingDetections::add(const PlotMark& plot, double persistence) {
  plots_.push_back(plot);
  while (plots_.front().time < plot.time - persistence) plots_.pop_front();
}

void FadingDetections::draw(Drawing& drawing, double time, double persistence, double size, const Rgba& color) const {
  for (const PlotMark& plot : plots_) {
    const double left = 1.0 - (time - plot.time) / persistence;
    if (left <= 0.0) continue;
    const Eigen::Vector2d ahead = unitVector(plot.azimuth);
    const Eigen::Vector2d half = 0.5 * size * Eigen::Vector2d(ahead.y(), -ahead.x());
    addLine(drawing, plot.position - half, plot.position + half, 0.45 * size, faded(color, left));
  }
}

}  // namespace tws_rviz
