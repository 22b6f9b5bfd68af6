#include "fading_detections.h"

namespace tws_rviz {

void FadingDetections::add(const Blip& blip, double persistence) {
  blips_.push_back(blip);
  while (blips_.front().time < blip.time - persistence) blips_.pop_front();
}

void FadingDetections::draw(Drawing& drawing, double time, double persistence, double size, const Rgba& color) const {
  for (const Blip& blip : blips_) {
    const double left = 1.0 - (time - blip.time) / persistence;
    if (left <= 0.0) continue;
    const Eigen::Vector2d ahead = unitVector(blip.azimuth);
    const Eigen::Vector2d half = 0.5 * size * Eigen::Vector2d(ahead.y(), -ahead.x());
    addLine(drawing, blip.position - half, blip.position + half, 0.45 * size, faded(color, left));
  }
}

}  // namespace tws_rviz
