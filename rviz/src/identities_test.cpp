#include "identities.h"

#include <gtest/gtest.h>

#include <limits>

namespace tws_rviz {
namespace {

const Eigen::Vector2d kEastward(200.0, 0.0);

// The operator would speak to another aircraft.
TEST(Identities, AreThoseOfTheNearestPlot) {
  Identities identities;
  identities.add({100.0, {10000.0, 0.0}, "1234 F350"});
  identities.add({100.0, {10000.0, 900.0}, "4321 F100"});
  EXPECT_EQ(identities.at(100.0, {10000.0, 100.0}, kEastward), "1234 F350");
  EXPECT_EQ(identities.at(100.0, {10000.0, 800.0}, kEastward), "4321 F100");
  EXPECT_EQ(identities.at(100.0, {10000.0, 3000.0}, kEastward), "");
}

TEST(Identities, OfAnEarlierPlotAreFoundWhereTheTrackWasThen) {
  Identities identities;
  identities.add({96.0, {9200.0, 0.0}, "1234"});
  identities.add({96.0, {10000.0, 0.0}, "4321"});
  EXPECT_EQ(identities.at(100.0, {10000.0, 0.0}, kEastward), "1234");
}

TEST(Identities, AreForgotten) {
  Identities identities;
  identities.add({100.0, {0.0, 0.0}, "1234"});
  EXPECT_EQ(identities.at(111.0, {0.0, 0.0}, {0.0, 0.0}), "");
}

// Of an unknown velocity nobody can say where the track was.
TEST(Identities, AreNotLentToATrackThatIsNowhere) {
  Identities identities;
  identities.add({100.0, {0.0, 0.0}, "1234"});
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(identities.at(100.0, {0.0, 0.0}, {unknown, unknown}), "");
}

}  // namespace
}  // namespace tws_rviz
