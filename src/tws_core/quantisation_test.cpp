#include <tws_core/quantisation.h>

#include <gtest/gtest.h>

namespace tws {
namespace {

// The report's files and its distance K1·DELR + K2·DELA count in these units.
TEST(LeastSignificantBits, AreThoseTheReportPrints) {
  EXPECT_NEAR(kRangeLsb, 19.05, 1e-12);
  EXPECT_NEAR(degrees(kAzimuthLsb), 0.010986, 5e-7);
  EXPECT_NEAR(kRangeRateLsb, 0.0762, 1e-12);
  EXPECT_NEAR(degrees(kAzimuthRateLsb), 0.000244, 5e-7);
  EXPECT_EQ(kTimeLsb, 0.008);
}

TEST(Quantise, TakesTheNearestMultiple) {
  EXPECT_DOUBLE_EQ(quantise(28.0, 19.05), 19.05);
  EXPECT_DOUBLE_EQ(quantise(29.0, 19.05), 38.1);
  EXPECT_DOUBLE_EQ(quantise(-29.0, 19.05), -38.1);
  EXPECT_EQ(quantise(0.4, 1.0), 0.0);
}

TEST(Quantise, TakesHalvesToTheEvenMultipleSoThatTheyDoNotDrift) {
  EXPECT_EQ(quantise(0.5, 1.0), 0.0);
  EXPECT_EQ(quantise(1.5, 1.0), 2.0);
  EXPECT_EQ(quantise(-2.5, 1.0), -2.0);
}

TEST(Quantise, LeavesTheValueWhenThereIsNoLeastSignificantBit) { EXPECT_EQ(quantise(0.1234, 0.0), 0.1234); }

}  // namespace
}  // namespace tws
