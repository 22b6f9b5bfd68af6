#include "background.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

namespace tws_rviz {
namespace {

std::map<std::string, Eigen::Vector2d> labels(const Drawing& drawing) {
  std::map<std::string, Eigen::Vector2d> places;
  for (const Label& label : drawing.labels) places[label.text] = label.centre;
  return places;
}

// Without distances at the rings an operator cannot read a range off the picture.
TEST(Background, RingsOfA200KmPictureStandAtFiftyKilometres) {
  EXPECT_DOUBLE_EQ(ringSpacing(200e3), 50e3);
  const auto places = labels(drawBackground(PpiStyle(200e3), 50e3));
  for (const double km : {50.0, 100.0, 150.0, 200.0}) {
    const std::string text = std::to_string(static_cast<int>(km));
    ASSERT_EQ(places.count(text), 1u) << text;
    EXPECT_NEAR(places.at(text).norm(), km * 1000.0, 1e-6);
  }
}

TEST(Background, AnyRangeGetsFourToTenRings) {
  for (int i = 0; i <= 100; ++i) {
    const double range = 1e3 * std::pow(10.0, 0.033 * i);  // to 2000 km
    const double rings = range / ringSpacing(range);
    EXPECT_GE(rings, 4.0) << range;
    EXPECT_LE(rings, 10.0) << range;
  }
}

// A mirrored or turned scale would put every aircraft in the wrong place.
TEST(Background, NorthIsUpAndEastIsRight) {
  const auto places = labels(drawBackground(PpiStyle(200e3), 50e3));
  EXPECT_NEAR(places.at("000").x(), 0.0, 1e-6);
  EXPECT_GT(places.at("000").y(), 200e3);
  EXPECT_GT(places.at("090").x(), 200e3);
  EXPECT_NEAR(places.at("090").y(), 0.0, 1e-6);
  EXPECT_NEAR(places.at("210").y() / places.at("210").norm(), -std::sqrt(3.0) / 2.0, 1e-9);
  EXPECT_NEAR(places.at("210").x() / places.at("210").norm(), -0.5, 1e-9);
}

TEST(Background, HasASpokeEachThirtyDegrees) {
  const auto places = labels(drawBackground(PpiStyle(200e3), 50e3));
  for (const char* bearing : {"000", "030", "060", "090", "120", "150", "180", "210", "240", "270", "300", "330"})
    EXPECT_EQ(places.count(bearing), 1u) << bearing;
}

// RViz replaces a text whose number comes twice.
TEST(Background, EveryLabelHasItsOwnNumber) {
  std::set<std::uint32_t> ids;
  const Drawing drawing = drawBackground(PpiStyle(123e3), 20e3);
  for (const Label& label : drawing.labels) EXPECT_TRUE(ids.insert(label.id).second);
  // 12 spokes; rings at 20, 40, 60, 80 and 100 km and at the rim. One at 120 km would lie on the rim's.
  EXPECT_EQ(ids.size(), 12u + 6u);
}

}  // namespace
}  // namespace tws_rviz
