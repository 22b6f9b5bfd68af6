#include "background.h"

#include <cmath>
#include <cstdio>

#include <tws_core/units.h>

namespace tws_rviz {
namespace {

constexpr int kSpokeStep = 30;  // [°]
constexpr int kTickStep = 5;
constexpr int kLongTickStep = 10;
constexpr int kRingCorners = 240;
// Ring labels stand on this bearing, clear of the spokes and of their labels.
constexpr double kRingLabelBearing = 15.0;

template <class... Args>
std::string format(const char* pattern, Args... args) {
  char text[32];
  std::snprintf(text, sizeof text, pattern, args...);
  return text;
}

void addLabel(Drawing& drawing, const Eigen::Vector2d& centre, const std::string& text, double height,
              const Rgba& color) {
  drawing.labels.push_back({static_cast<std::uint32_t>(drawing.labels.size()), centre, height, text, color});
}

void addRing(Drawing& drawing, const PpiStyle& style, double radius) {
  addPolygon(drawing, Eigen::Vector2d::Zero(), {kRingCorners, radius, 0.0}, style.line, style.ring);
  addLabel(drawing, radius * unitVector(tws::radians(kRingLabelBearing)), format("%g", radius / 1000.0),
           style.small_text, style.scale_text);
}

void addSpokes(Drawing& drawing, const PpiStyle& style, double inner) {
  for (int bearing = 0; bearing < 360; bearing += kSpokeStep) {
    const Eigen::Vector2d direction = unitVector(tws::radians(bearing));
    addLine(drawing, inner * direction, style.range * direction, style.line, style.spoke);
    addLabel(drawing, (style.range + 1.3 * style.text) * direction, format("%03d", bearing), style.text,
             style.scale_text);
  }
}

void addTicks(Drawing& drawing, const PpiStyle& style) {
  for (int bearing = 0; bearing < 360; bearing += kTickStep) {
    const Eigen::Vector2d direction = unitVector(tws::radians(bearing));
    const double length = (bearing % kLongTickStep == 0 ? 0.02 : 0.01) * style.range;
    addLine(drawing, style.range * direction, (style.range + length) * direction, style.line, style.ring);
  }
}

}  // namespace

double ringSpacing(double range) {
  const double rough = range / 4.0;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double step : {5.0, 2.0})
    if (rough >= step * power) return step * power;
  return power;
}

Drawing drawBackground(const PpiStyle& style, double spacing) {
  Drawing drawing;
  addSpokes(drawing, style, 0.0);
  addTicks(drawing, style);
  // A ring nearer to the rim than a quarter of the spacing would only crowd it.
  for (int i = 1; i * spacing < style.range - 0.25 * spacing; ++i) addRing(drawing, style, i * spacing);
  addRing(drawing, style, style.range);
  return drawing;
}

}  // namespace tws_rviz
