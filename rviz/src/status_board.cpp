#include "status_board.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tws_rviz {
namespace {

// The corners of the square round the picture, bearings included.
constexpr double kLeft = -1.07;
constexpr double kTop = 1.07;
constexpr double kRight = 0.76;

// Writes lines one below the other.
class Column {
 public:
  Column(Drawing& drawing, const Eigen::Vector2d& corner, double height)
      : drawing_(drawing), corner_(corner), height_(height) {}

  void write(const std::string& text, const Rgba& color) {
    const auto id = static_cast<std::uint32_t>(drawing_.labels.size());
    drawing_.labels.push_back(labelFromCorner(id, corner_, text, height_, color));
    corner_.y() -= 1.25 * height_;
  }

  /// The first of the texts that stays out of a circle round the origin, or else the last.
  void writeOutside(double radius, const std::vector<std::string>& texts, const Rgba& color) {
    const auto is_outside = [&](const std::string& text) {
      const Eigen::Vector2d size = textSize(text, height_);
      return (corner_ + Eigen::Vector2d(size.x(), -size.y())).norm() > radius;
    };
    const auto found = std::find_if(texts.begin(), texts.end(), is_outside);
    write(found == texts.end() ? texts.back() : *found, color);
  }

 private:
  Drawing& drawing_;
  Eigen::Vector2d corner_;
  double height_;
};

std::string kilometres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", metres / 1000.0);
  return text;
}

/// What there is to say of a radar, the longest first.
std::vector<std::string> radarTexts(const RadarStatus& radar) {
  if (!radar.turning) return {radar.name + "  silent"};
  char period[32];
  std::snprintf(period, sizeof period, "  %.1f s", radar.rotation_period);
  const std::string brief = radar.name + period;
  if (radar.alignment.empty()) return {brief};
  return {brief + "  " + radar.alignment, radar.name + "  " + radar.alignment, brief + "  aligned", brief + " *"};
}

}  // namespace

std::string clockText(double time) {
  const long seconds = static_cast<long>(std::floor(time)) % 86400;
  char text[32];
  std::snprintf(text, sizeof text, "%02ld:%02ld:%02ld", seconds / 3600, seconds / 60 % 60, seconds % 60);
  return text;
}

Drawing drawStatus(const PpiStyle& style, const PpiStatus& status) {
  Drawing drawing;
  Column left(drawing, style.range * Eigen::Vector2d(kLeft, kTop), style.text);
  left.write(clockText(status.time), style.firm);
  left.write(kilometres(style.range) + " km / " + kilometres(status.spacing), style.scale_text);
  for (const RadarStatus& radar : status.radars) left.writeOutside(style.range, radarTexts(radar), radar.color);
  Column right(drawing, style.range * Eigen::Vector2d(kRight, kTop), style.text);
  for (const TrackerStatus& tracker : status.trackers) {
    right.write(tracker.name, style.scale_text);
    right.write("firm " + std::to_string(tracker.counts[1]), style.firm);
    right.write("coasting " + std::to_string(tracker.counts[2]), style.coasting);
    right.write("tentative " + std::to_string(tracker.counts[0]), style.tentative);
  }
  if (status.clutter) right.write("clutter " + std::to_string(*status.clutter), style.clutter);
  return drawing;
}

}  // namespace tws_rviz
