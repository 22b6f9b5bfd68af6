#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

namespace tws_rviz {

/// Colour and opacity, each in [0, 1].
struct Rgba {
  float r = 1.0f;
  float g = 1.0f;
  float b = 1.0f;
  float a = 1.0f;
};

/// The colour with its opacity multiplied by `factor`, which is limited to [0, 1].
Rgba faded(const Rgba& color, double factor);

struct Vertex {
  Eigen::Vector2d position;  // x east, y north [m]
  Rgba color;
};

struct Label {
  std::uint32_t id = 0;    // the same label keeps its number from picture to picture
  Eigen::Vector2d centre;  // of the block of text [m]
  double height = 0.0;     // of a line [m]
  std::string text;        // lines separated by '\n', all starting at the same left edge
  Rgba color;
};

/// What is drawn on one layer. All lines are thin rectangles: RViz turns the lines of LINE_LIST and the squares of
/// POINTS towards the eye's *place*, so in a view from above they stand on edge, and vanish, far from the middle of the
/// picture.
struct Drawing {
  std::vector<Vertex> triangles;  // three by three; later ones cover earlier ones
  std::vector<Label> labels;
};

/// A closed regular polygon drawn by its border. 4 corners with the first one north are a diamond; many are a circle.
struct Polygon {
  int corners = 4;             // at least 3
  double radius = 0.0;         // of the border's middle, at the corners [m]
  double first_azimuth = 0.0;  // of a corner [rad]
};

/// East and north of a direction given clockwise from north [rad].
Eigen::Vector2d unitVector(double azimuth);

void addTriangle(Drawing& drawing, const Vertex& a, const Vertex& b, const Vertex& c);
/// A straight line of `width` [m]; nothing when it has no length.
void addLine(Drawing& drawing, const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width, const Rgba& color);
/// `width` [m] is that of the border at the corners.
void addPolygon(Drawing& drawing, const Eigen::Vector2d& centre, const Polygon& polygon, double width,
                const Rgba& color);
/// A filled square with sides of `size` [m].
void addDot(Drawing& drawing, const Eigen::Vector2d& centre, double size, const Rgba& color);
/// Two crossing lines of length `size` [m], the first in the direction `azimuth` [rad], the other across.
void addCross(Drawing& drawing, const Eigen::Vector2d& centre, double size, double azimuth, double width,
              const Rgba& color);

/// Width and height [m] that RViz gives a block of text with lines of `height` [m] (Liberation Sans; good to about a
/// tenth).
Eigen::Vector2d textSize(const std::string& text, double height);
/// A label whose left edge and upper edge are at `corner`.
Label labelFromCorner(std::uint32_t id, const Eigen::Vector2d& corner, const std::string& text, double height,
                      const Rgba& color);

}  // namespace tws_rviz
