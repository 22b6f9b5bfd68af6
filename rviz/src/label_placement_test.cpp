#include "label_placement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace tws_rviz {
namespace {

LabelRequest request(double x, double y, int side) { return {{x, y}, {200.0, 90.0}, 40.0, side}; }

double overlap(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& size) {
  const double x = std::max(0.0, size.x() - std::abs(a.x() - b.x()));
  const double y = std::max(0.0, size.y() - std::abs(a.y() - b.y()));
  return x * y;
}

double totalOverlap(const std::vector<LabelRequest>& requests, const std::vector<int>& sides) {
  double sum = 0.0;
  for (std::size_t i = 0; i < requests.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      sum += overlap(labelCentre(requests[i], sides[i]), labelCentre(requests[j], sides[j]), requests[i].size);
  return sum;
}

// A label that jumps about without need cannot be read.
TEST(LabelPlacement, ALabelAloneStaysOnItsSide) {
  for (int side = 0; side < kLabelSides; ++side)
    EXPECT_EQ(placeLabels({request(0.0, 0.0, side)}), std::vector<int>{side});
}

TEST(LabelPlacement, TheSidesAreRoundTheSymbol) {
  const LabelRequest here = request(1000.0, 2000.0, 0);
  EXPECT_EQ(labelCentre(here, 0), Eigen::Vector2d(1140.0, 2000.0));
  EXPECT_EQ(labelCentre(here, 2), Eigen::Vector2d(1000.0, 1915.0));
  EXPECT_EQ(labelCentre(here, 4), Eigen::Vector2d(860.0, 2000.0));
  EXPECT_EQ(labelCentre(here, 6), Eigen::Vector2d(1000.0, 2085.0));
  EXPECT_GT(labelCentre(here, 7).x(), 1000.0);
  EXPECT_GT(labelCentre(here, 7).y(), 2000.0);
}

// Two aircraft side by side: without this their numbers lie over each other.
TEST(LabelPlacement, TwoLabelsOfTheSamePlaceDoNotOverlap) {
  const std::vector<LabelRequest> requests{request(0.0, 0.0, 0), request(0.0, 10.0, 0)};
  const std::vector<int> sides = placeLabels(requests);
  EXPECT_NE(sides[0], sides[1]);
  EXPECT_EQ(totalOverlap(requests, sides), 0.0);
}

TEST(LabelPlacement, InACrowdLabelsOverlapMuchLessThanUnplaced) {
  const unsigned seed = 20240711;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(-2000.0, 2000.0);
  std::vector<LabelRequest> requests(60);
  for (LabelRequest& one : requests) one = request(place(random), place(random), 0);
  const double before = totalOverlap(requests, std::vector<int>(requests.size(), 0));
  ASSERT_GT(before, 0.0);
  EXPECT_LT(totalOverlap(requests, placeLabels(requests)), 0.5 * before);
}

// Placing is quadratic; with thousands of tracks it must not stop the picture.
TEST(LabelPlacement, OfVeryManyLabelsEachKeepsItsSide) {
  const std::vector<LabelRequest> requests(5000, request(0.0, 0.0, 3));
  EXPECT_EQ(placeLabels(requests), std::vector<int>(5000, 3));
}

}  // namespace
}  // namespace tws_rviz
