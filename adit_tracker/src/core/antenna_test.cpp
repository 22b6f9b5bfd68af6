#include "core/antenna.h"

#include <gtest/gtest.h>

namespace adit_tracker {
namespace {

constexpr double kWidth = tws::kSectorWidth;

TEST(Antenna, KnowsNothingBeforeItsFirstMark) {
  Antenna antenna(6.0);
  EXPECT_FALSE(antenna.known());
  antenna.mark(0, 0.0);
  EXPECT_TRUE(antenna.known());
}

// If this fails, tracks of a radar that has just been switched on are predicted for the wrong instant.
TEST(Antenna, TurnsByTheGivenPeriodUntilAWholeTurnIsSeen) {
  Antenna antenna(6.0);
  for (int i = 0; i < 64; ++i) antenna.mark(i, 0.125 * i);  // It really takes 8 s.
  EXPECT_DOUBLE_EQ(antenna.period(), 6.0);
  antenna.mark(64, 8.0);
  EXPECT_DOUBLE_EQ(antenna.period(), 8.0);
  EXPECT_DOUBLE_EQ(antenna.sectorDuration(), 0.125);
  EXPECT_DOUBLE_EQ(antenna.rate(), 2.0 * 3.14159265358979323846 / 8.0);
}

TEST(Antenna, FollowsAChangeOfItsSpeed) {
  Antenna antenna(8.0);
  for (int i = 0; i <= 64; ++i) antenna.mark(i, 0.125 * i);
  for (int i = 1; i <= 64; ++i) antenna.mark(64 + i, 8.0 + 0.1 * i);
  EXPECT_NEAR(antenna.period(), 6.4, 1e-12);
}

TEST(Antenna, GoesEvenlyBetweenTwoMarks) {
  Antenna antenna(6.0);
  antenna.mark(10, 1.0);
  antenna.mark(11, 1.2);
  antenna.mark(12, 1.3);
  EXPECT_NEAR(antenna.timeAt(10.0 * kWidth), 1.0, 1e-12);
  EXPECT_NEAR(antenna.timeAt(10.25 * kWidth), 1.05, 1e-12);
  EXPECT_NEAR(antenna.timeAt(11.5 * kWidth), 1.25, 1e-12);
}

TEST(Antenna, GoesOnByItsPeriodBeyondTheNewestMark) {
  Antenna antenna(6.4);
  antenna.mark(10, 1.0);
  EXPECT_NEAR(antenna.timeAt(13.0 * kWidth), 1.3, 1e-12);
  EXPECT_NEAR(antenna.timeAt((10.0 + 64.0) * kWidth), 7.4, 1e-12);
}

// If this fails, lost marks bring a wrong period or a time from two turns ago.
TEST(Antenna, BridgesAGapInTheMarks) {
  Antenna antenna(6.4);
  for (int i = 0; i <= 70; ++i) antenna.mark(i, 0.1 * i);
  antenna.mark(200, 20.0);
  EXPECT_DOUBLE_EQ(antenna.period(), 6.4);
  EXPECT_NEAR(antenna.timeAt(199.0 * kWidth), 19.9, 1e-9);  // Marks 71 .. 199 are missing.
  EXPECT_NEAR(antenna.timeAt(201.0 * kWidth), 20.1, 1e-9);
}

}  // namespace
}  // namespace adit_tracker
