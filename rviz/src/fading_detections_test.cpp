#include "fading_detections.h"

#include <gtest/gtest.h>

#include <tws_core/angles.h>

namespace tws_rviz {
namespace {

const Rgba kGreen{0.0f, 1.0f, 0.0f, 1.0f};

Drawing drawnAt(const FadingDetections& detections, double time) {
  Drawing drawing;
  detections.draw(drawing, time, 12.0, 100.0, kGreen);
  return drawing;
}

// Two scans of afterglow let an operator see a target move, and an old false alarm go.
TEST(FadingDetections, FadeFromFullColourToNothing) {
  FadingDetections detections;
  detections.add({50.0, {1000.0, 0.0}, 0.0}, 12.0);
  EXPECT_FLOAT_EQ(drawnAt(detections, 50.0).triangles.at(0).color.a, 1.0f);
  EXPECT_FLOAT_EQ(drawnAt(detections, 56.0).triangles.at(0).color.a, 0.5f);
  EXPECT_FLOAT_EQ(drawnAt(detections, 59.0).triangles.at(0).color.a, 0.25f);
  EXPECT_TRUE(drawnAt(detections, 62.0).triangles.empty());
}

// Messages may arrive a little before /clock has come to their stamp.
TEST(FadingDetections, OneAheadOfDataTimeIsShownInFullColour) {
  FadingDetections detections;
  detections.add({50.0, {1000.0, 0.0}, 0.0}, 12.0);
  EXPECT_FLOAT_EQ(drawnAt(detections, 49.5).triangles.at(0).color.a, 1.0f);
}

// As on a real tube: the beam is wide, the pulse is short.
TEST(FadingDetections, APlotLiesAcrossTheBeam) {
  FadingDetections detections;
  detections.add({50.0, {0.0, 1000.0}, 0.0}, 12.0);  // due north
  double east = 0.0;
  double north = 0.0;
  for (const Vertex& vertex : drawnAt(detections, 50.0).triangles) {
    east = std::max(east, std::abs(vertex.position.x()));
    north = std::max(north, std::abs(vertex.position.y() - 1000.0));
  }
  EXPECT_NEAR(east, 50.0, 1e-9);
  EXPECT_LT(north, 0.5 * east);
}

// Else an hour's run fills the memory when nobody looks.
TEST(FadingDetections, ForgetsWhatHasFaded) {
  FadingDetections detections;
  for (int i = 0; i < 100000; ++i) detections.add({0.01 * i, {0.0, 1000.0}, 0.0}, 12.0);
  EXPECT_LE(detections.size(), 1202u);
}

}  // namespace
}  // namespace tws_rviz
