#include "drawing.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/angles.h>

namespace tws_rviz {
namespace {

double area(const Drawing& drawing) {
  double sum = 0.0;
  for (std::size_t i = 0; i + 2 < drawing.triangles.size(); i += 3) {
    const Eigen::Vector2d ab = drawing.triangles[i + 1].position - drawing.triangles[i].position;
    const Eigen::Vector2d ac = drawing.triangles[i + 2].position - drawing.triangles[i].position;
    sum += 0.5 * std::abs(ab.x() * ac.y() - ab.y() * ac.x());
  }
  return sum;
}

// Else speed leaders and rings would be too thin to see, or blots.
TEST(Drawing, ALineCoversItsLengthTimesItsWidth) {
  Drawing drawing;
  addLine(drawing, {100.0, 200.0}, {400.0, 600.0}, 10.0, {});  // 500 m long
  EXPECT_EQ(drawing.triangles.size(), 6u);
  EXPECT_NEAR(area(drawing), 5000.0, 1e-6);
}

// A track without speed has a leader without length; it must not become NaN on the screen.
TEST(Drawing, ALineWithoutLengthDrawsNothing) {
  Drawing drawing;
  addLine(drawing, {1.0, 2.0}, {1.0, 2.0}, 10.0, {});
  EXPECT_TRUE(drawing.triangles.empty());
}

// The operator tells firm from tentative by this shape.
TEST(Drawing, APolygonWithFourCornersFromNorthIsADiamond) {
  Drawing drawing;
  addPolygon(drawing, {1000.0, 0.0}, {4, 100.0, 0.0}, 2.0, {});
  double north = -1e9;
  double east = -1e9;
  for (const Vertex& vertex : drawing.triangles) {
    north = std::max(north, vertex.position.y());
    east = std::max(east, vertex.position.x());
    // On a diamond |x| + |y| is the radius, within half the border.
    const double sum = std::abs(vertex.position.x() - 1000.0) + std::abs(vertex.position.y());
    EXPECT_NEAR(sum, 100.0, 1.0 + 1e-9);
  }
  EXPECT_NEAR(north, 101.0, 1e-9);
  EXPECT_NEAR(east, 1101.0, 1e-9);
}

TEST(Drawing, APolygonWithManyCornersIsARangeRing) {
  Drawing drawing;
  addPolygon(drawing, {0.0, 0.0}, {240, 50000.0, 0.0}, 100.0, {});
  for (const Vertex& vertex : drawing.triangles) EXPECT_NEAR(vertex.position.norm(), 50000.0, 50.0 + 1e-6);
  // The ring of a circle: 2 pi r times its width, less what 240 corners cut off.
  EXPECT_NEAR(area(drawing), tws::kTwoPi * 50000.0 * 100.0, 0.001 * tws::kTwoPi * 50000.0 * 100.0);
}

TEST(Drawing, ACrossHasTwoStrokesOfItsSize) {
  Drawing drawing;
  addCross(drawing, {0.0, 0.0}, 100.0, tws::kPi / 4.0, 2.0, {});
  EXPECT_NEAR(area(drawing), 2.0 * 100.0 * 2.0, 1e-9);
}

// Fading must end at nothing, and never make a colour brighter than it is.
TEST(Drawing, FadingLimitsTheOpacity) {
  const Rgba color{0.1f, 0.2f, 0.3f, 0.8f};
  EXPECT_FLOAT_EQ(faded(color, 0.5).a, 0.4f);
  EXPECT_FLOAT_EQ(faded(color, 1.5).a, 0.8f);
  EXPECT_FLOAT_EQ(faded(color, -1.0).a, 0.0f);
}

// Labels that are placed by a wrong size cover each other. The widths were read off RViz's screen: at a line height of
// 20 pixels ten digits took 93 pixels, and "ABCDEFGHIJ KLM" 154.
TEST(Drawing, TheSizeOfTextIsThatOnTheScreen) {
  EXPECT_NEAR(textSize("0123456789", 20.0).x(), 93.0, 5.0);
  EXPECT_NEAR(textSize("ABCDEFGHIJ KLM", 20.0).x(), 154.0, 10.0);
  EXPECT_DOUBLE_EQ(textSize("17\n312kn\n4271 F350", 20.0).y(), 60.0);
  EXPECT_DOUBLE_EQ(textSize("17\n312kn\n4271 F350", 20.0).x(), textSize("4271 F350", 20.0).x());
}

TEST(Drawing, ALabelFromItsCornerHasItsLeftUpperEdgeThere) {
  const Label label = labelFromCorner(3, {-100.0, 50.0}, "0123", 10.0, {});
  const Eigen::Vector2d size = textSize("0123", 10.0);
  EXPECT_DOUBLE_EQ(label.centre.x() - size.x() / 2.0, -100.0);
  EXPECT_DOUBLE_EQ(label.centre.y() + size.y() / 2.0, 50.0);
  EXPECT_EQ(label.id, 3u);
}

}  // namespace
}  // namespace tws_rviz
