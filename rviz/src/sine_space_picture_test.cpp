#include "sine_space_picture.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tws_rviz {
namespace {

DwellMark dwell(double time, std::uint32_t number, std::vector<SineSpaceMeasurement> measurements = {}) {
  return {time, number, true, 0.1, -0.2, 0.04, 0.02, std::move(measurements), 0, 0};
}

SineSpacePicture picture() { return {0.5, -0.3, 0.1, 2.0}; }

/// Extent of what is drawn, in units of sine space.
struct Extent {
  double left = 1e9, right = -1e9, low = 1e9, high = -1e9;
};

Extent extentOf(const Drawing& drawing) {
  Extent extent;
  for (const Vertex& vertex : drawing.triangles) {
    const Eigen::Vector2d place = vertex.position / SineSpacePicture::kMetresPerUnit;
    extent.left = std::min(extent.left, place.x());
    extent.right = std::max(extent.right, place.x());
    extent.low = std::min(extent.low, place.y());
    extent.high = std::max(extent.high, place.y());
  }
  return extent;
}

// The eye judges overlap by these contours: half a beamwidth to each side, in u and in v.
TEST(SineSpacePicture, DrawsABeamAsItsHalfPowerContour) {
  SineSpacePicture shown = picture();
  shown.add(dwell(10.0, 1));
  const Extent extent = extentOf(shown.beams(10.0));
  EXPECT_NEAR(extent.left, 0.08, 0.002);
  EXPECT_NEAR(extent.right, 0.12, 0.002);
  EXPECT_NEAR(extent.low, -0.21, 0.002);
  EXPECT_NEAR(extent.high, -0.19, 0.002);
}

TEST(SineSpacePicture, DwellsFadeWithTimeAndAreForgotten) {
  SineSpacePicture shown = picture();
  shown.add(dwell(10.0, 1));
  const float fresh = shown.beams(10.0).triangles.at(0).color.a;
  EXPECT_NEAR(shown.beams(11.0).triangles.at(0).color.a, fresh / 2.0f, 1e-5);
  shown.add(dwell(12.5, 2));
  const std::size_t one_contour = 36 * 6;
  EXPECT_EQ(shown.beams(12.5).triangles.size(), one_contour);
}

// What selection discards is the point of the picture: a measurement of the dwell that the frame no longer holds.
TEST(SineSpacePicture, MarksMeasurementsThatAFrameDidNotKeepAsDiscarded) {
  SineSpacePicture shown = picture();
  shown.add(dwell(10.0, 1, {{50e3, 0.1, -0.2}, {51e3, 0.1, -0.2}, {52e3, 0.11, -0.2}}));
  EXPECT_TRUE(shown.measurements(10.0).triangles.empty()) << "nothing is decided before the frame closes";
  shown.add(FrameMark{10.1, 7, {dwell(10.0, 1, {{50e3, 0.1, -0.2}, {52e3, 0.11, -0.2}})}});
  const Drawing measurements = shown.measurements(10.1);
  EXPECT_EQ(measurements.triangles.size(), 2u * 6u + 1u * 12u);  // Two dots, one cross of two strokes.
  EXPECT_EQ(shown.status().labels.at(0).text, "frame 7: 1 dwells, 2 kept, 1 discarded");
}

TEST(SineSpacePicture, AFrameWhoseDwellsDidNotComeShowsWhatItHolds) {
  SineSpacePicture shown = picture();
  shown.add(FrameMark{10.1, 7, {dwell(10.0, 1, {{50e3, 0.1, -0.2}})}});
  EXPECT_EQ(shown.measurements(10.1).triangles.size(), 6u);
}

TEST(SineSpacePicture, LabelsFirmTracksWithTheirNumbers) {
  SineSpacePicture shown = picture();
  shown.setTracks({{42, true, 0.1, 0.1}, {43, false, 0.2, 0.1}});
  const Drawing tracks = shown.tracks();
  ASSERT_EQ(tracks.labels.size(), 1u);
  EXPECT_EQ(tracks.labels[0].text, "42");
}

// Grid lines every 0.1: 11 by 5, the names of the axes, and what the inset is.
TEST(SineSpacePicture, HasAGridWithNumbers) { EXPECT_EQ(picture().background().labels.size(), 11u + 5u + 2u + 1u); }

// Closely spaced objects are what the array is for, and too close for the picture as a whole.
TEST(SineSpacePicture, MagnifiesTheSequenceOfMostBeamsInTheInset) {
  SineSpacePicture shown = picture();
  DwellMark one = dwell(10.0, 1), two = dwell(10.01, 2);
  one.group = two.group = 5;
  one.group_dwells = two.group_dwells = 2;
  two.u = 0.12;
  shown.add(one);
  shown.add(two);
  shown.setTracks({{42, true, 0.11, -0.2}, {43, true, 0.12, -0.2}, {44, true, -0.4, -0.2}});
  const Drawing tracks = shown.tracks();
  ASSERT_EQ(tracks.labels.size(), 3u);  // 44 in the picture, the others in the inset, six times as far apart:
  EXPECT_EQ(tracks.labels[0].text, "44");
  EXPECT_NEAR(tracks.labels[2].centre.x() - tracks.labels[1].centre.x(), 0.06 * SineSpacePicture::kMetresPerUnit, 1e-6);
}

}  // namespace
}  // namespace tws_rviz
