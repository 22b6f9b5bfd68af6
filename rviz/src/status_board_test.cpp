#include "status_board.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tws_rviz {
namespace {

bool says(const Drawing& drawing, const std::string& text) {
  return std::any_of(drawing.labels.begin(), drawing.labels.end(),
                     [&](const Label& label) { return label.text == text; });
}

TEST(StatusBoard, TheClockCountsFromMidnight) {
  EXPECT_EQ(clockText(0.0), "00:00:00");
  EXPECT_EQ(clockText(125.9), "00:02:05");
  EXPECT_EQ(clockText(86400.0 * 3 + 3661.0), "01:01:01");
}

// An operator must see that a radar has failed, and how many tracks there are of each kind.
TEST(StatusBoard, NamesTurningAndSilentRadarsAndCountsTracks) {
  const PpiStatus status{
      60.0, 50e3, {{"sps12", {}, 6.0, true, ""}, {"sps39", {}, NAN, false, ""}}, {{"adit", {9, 47, 3}}}, 17};
  const Drawing drawing = drawStatus(PpiStyle(200e3), status);
  EXPECT_TRUE(says(drawing, "00:01:00"));
  EXPECT_TRUE(says(drawing, "200 km / 50"));
  EXPECT_TRUE(says(drawing, "sps12  6.0 s"));
  EXPECT_TRUE(says(drawing, "sps39  silent"));
  EXPECT_TRUE(says(drawing, "firm 47"));
  EXPECT_TRUE(says(drawing, "coasting 3"));
  EXPECT_TRUE(says(drawing, "tentative 9"));
}

// An operator must see what is taken out of a radar's plots.
TEST(StatusBoard, SaysHowARadarIsAligned) {
  const PpiStatus status{60.0, 50e3, {{"sps12", {}, 6.0, true, "+40 m"}, {"sps39", {}, NAN, false, "+1 m"}}, {}, {}};
  const Drawing drawing = drawStatus(PpiStyle(200e3), status);
  EXPECT_TRUE(says(drawing, "sps12  6.0 s  +40 m"));
  EXPECT_TRUE(says(drawing, "sps39  silent"));
}

// Text within the circle would hide aircraft.
TEST(StatusBoard, StandsOutsideOfTheCircle) {
  const PpiStatus status{
      60.0, 50e3, {{"sps12", {}, 6.0, true, ""}, {"sps39", {}, 8.0, true, ""}}, {{"adit", {9, 47, 3}}}, 17};
  for (const Label& label : drawStatus(PpiStyle(200e3), status).labels) EXPECT_GT(label.centre.norm(), 200e3);
  PpiStatus six{60.0, 50e3, {}, {}, {}};
  for (int i = 0; i < 6; ++i) six.radars.push_back({"south_west", {}, 12.0, true, "-60 m +0.25 deg"});
  for (const Label& label : drawStatus(PpiStyle(200e3), six).labels) {
    const Eigen::Vector2d size = textSize(label.text, label.height);
    EXPECT_GT((label.centre + Eigen::Vector2d(0.5 * size.x(), -0.5 * size.y())).norm(), 200e3) << label.text;
  }
}

}  // namespace
}  // namespace tws_rviz
