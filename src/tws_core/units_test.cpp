#include <tws_core/units.h>

#include <gtest/gtest.h>

namespace tws {
namespace {

// A wrong factor shifts every displayed range, speed and gate.
TEST(Units, FollowTheInternationalDefinitions) {
  EXPECT_DOUBLE_EQ(metresFromFeet(62.5), 19.05);  // printed in NRL Report 7952
  EXPECT_DOUBLE_EQ(metresFromNauticalMiles(10.0), 18520.0);
  EXPECT_DOUBLE_EQ(speedFromKnots(3600.0), 1852.0);
  EXPECT_DOUBLE_EQ(radians(180.0), 3.141592653589793);
}

TEST(Units, ConvertBackToWhatTheyCameFrom) {
  EXPECT_DOUBLE_EQ(feetFromMetres(metresFromFeet(2000.0)), 2000.0);
  EXPECT_DOUBLE_EQ(nauticalMilesFromMetres(metresFromNauticalMiles(12.5)), 12.5);
  EXPECT_DOUBLE_EQ(knotsFromSpeed(speedFromKnots(45.0)), 45.0);
  EXPECT_DOUBLE_EQ(degrees(radians(5.625)), 5.625);
}

}  // namespace
}  // namespace tws
