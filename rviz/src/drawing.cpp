#include "drawing.h"

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/geometry.h>

namespace tws_rviz {
namespace {

// Corners in order round the quad.
void addQuad(Drawing& drawing, const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c,
             const Eigen::Vector2d& d, const Rgba& color) {
  addTriangle(drawing, {a, color}, {b, color}, {c, color});
  addTriangle(drawing, {a, color}, {c, color}, {d, color});
}

// Share of the line height that a character is wide: the advances of Liberation Sans over its line height. RViz makes a
// space as wide as an 'A'.
double characterWidth(char c) {
  static const std::string narrow = "ijl";
  static const std::string slim = "ft.,:/I";
  if (narrow.find(c) != std::string::npos) return 0.19;
  if (slim.find(c) != std::string::npos) return 0.23;
  if (c >= '0' && c <= '9') return 0.466;
  return c >= 'a' && c <= 'z' ? 0.45 : 0.57;
}

}  // namespace

Rgba faded(const Rgba& color, double factor) {
  Rgba result = color;
  result.a *= static_cast<float>(std::clamp(factor, 0.0, 1.0));
  return result;
}

Eigen::Vector2d unitVector(double azimuth) { return tws::planarFromPolar(1.0, azimuth); }

void addTriangle(Drawing& drawing, const Vertex& a, const Vertex& b, const Vertex& c) {
  drawing.triangles.insert(drawing.triangles.end(), {a, b, c});
}

void addLine(Drawing& drawing, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width,
             const Rgba& color) {
  const Eigen::Vector2d along = to - from;
  const double length = along.norm();
  if (!(length > 0.0)) return;
  const Eigen::Vector2d side = Eigen::Vector2d(-along.y(), along.x()) * (0.5 * width / length);
  addQuad(drawing, from + side, to + side, to - side, from - side, color);
}

void addPolygon(Drawing& drawing, const Eigen::Vector2d& centre, const Polygon& polygon, double width,
                const Rgba& color) {
  const double inner = polygon.radius - 0.5 * width;
  const double outer = polygon.radius + 0.5 * width;
  const double step = tws::kTwoPi / polygon.corners;
  for (int i = 0; i < polygon.corners; ++i) {
    const Eigen::Vector2d one = unitVector(polygon.first_azimuth + i * step);
    const Eigen::Vector2d next = unitVector(polygon.first_azimuth + (i + 1) * step);
    addQuad(drawing, centre + inner * one, centre + outer * one, centre + outer * next, centre + inner * next, color);
  }
}

void addDot(Drawing& drawing, const Eigen::Vector2d& centre, double size, const Rgba& color) {
  const Eigen::Vector2d half(0.5 * size, 0.0);
  addLine(drawing, centre - half, centre + half, size, color);
}

void addCross(Drawing& drawing, const Eigen::Vector2d& centre, double size, double azimuth, double width,
              const Rgba& color) {
  const Eigen::Vector2d arm = 0.5 * size * unitVector(azimuth);
  const Eigen::Vector2d across(arm.y(), -arm.x());
  addLine(drawing, centre - arm, centre + arm, width, color);
  addLine(drawing, centre - across, centre + across, width, color);
}

Eigen::Vector2d textSize(const std::string& text, double height) {
  double widest = 0.0;
  double width = 0.0;
  int lines = 1;
  for (const char c : text) {
    lines += c == '\n';
    width = c == '\n' ? 0.0 : width + characterWidth(c);
    widest = std::max(widest, width);
  }
  return {widest * height, lines * height};
}

Label labelFromCorner(std::uint32_t id, const Eigen::Vector2d& corner, const std::string& text, double height,
                      const Rgba& color) {
  const Eigen::Vector2d size = textSize(text, height);
  return {id, corner + Eigen::Vector2d(0.5 * size.x(), -0.5 * size.y()), height, text, color};
}

}  // namespace tws_rviz
