#include "clutter/area.h"

#include <gtest/gtest.h>

namespace radar_sim {
namespace {

// If it fails, there is sea on land.
TEST(Area, KnowsWhatLiesWithinAConcaveBorder) {
  const Area bay({{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {5.0, 2.0}, {0.0, 10.0}});
  EXPECT_TRUE(bay.contains({1.0, 5.0}));
  EXPECT_TRUE(bay.contains({9.0, 5.0}));
  EXPECT_TRUE(bay.contains({5.0, 1.0}));
  EXPECT_FALSE(bay.contains({5.0, 5.0}));
  EXPECT_FALSE(bay.contains({-1.0, 5.0}));
  EXPECT_FALSE(bay.contains({11.0, 5.0}));
  EXPECT_TRUE(Area().contains({1e9, -1e9}));
}

TEST(Area, OutlineHasAllCornersAndFillsTheSides) {
  const Area square({{0.0, 0.0}, {0.0, 100.0}, {100.0, 100.0}, {100.0, 0.0}});
  const auto outline = square.outline();
  ASSERT_EQ(outline.size(), 60u);
  EXPECT_EQ(outline[15], Eigen::Vector2d(0.0, 100.0));
  for (std::size_t i = 1; i < outline.size(); ++i) EXPECT_NEAR((outline[i] - outline[i - 1]).norm(), 100.0 / 15, 1e-9);
  EXPECT_TRUE(Area().outline().empty());
}

}  // namespace
}  // namespace radar_sim
