#include "data_clock.h"

#include <gtest/gtest.h>

#include <cmath>

namespace asterix_bridge {
namespace {

constexpr double kDay = 86400.0;
constexpr double kNoon = 20000.0 * kDay + 43200.0;  // of some day

TEST(DataClock, TakesTheDayNearestToTheFirstRecord) {
  EXPECT_DOUBLE_EQ(DataClock(kNoon).full(100.0), 20000.0 * kDay + 100.0);
  EXPECT_DOUBLE_EQ(DataClock(kNoon).full(86300.0), 20000.0 * kDay + 86300.0);
  EXPECT_DOUBLE_EQ(DataClock(20000.0 * kDay + 100.0).full(86300.0), 20000.0 * kDay - 100.0);
}

// A recording over midnight must not jump back by a day: every track would be lost.
TEST(DataClock, GoesOnOverMidnight) {
  DataClock clock(kNoon);
  double last = clock.full(86390.0);
  for (double time = 86391.0; time < 2.0 * kDay + 100.0; time += 1.0) {
    const double full = clock.full(std::fmod(time, kDay));
    ASSERT_DOUBLE_EQ(full, last + 1.0);
    last = full;
  }
}

// CAT001 sends 16 bits of time, which start anew every 512 s: 168.75 times a day, so not at midnight.
TEST(DataClock, RebuildsTheTruncatedTimeOfDay) {
  DataClock clock(kNoon);
  clock.full(86000.0);
  for (double time = 86000.25; time < kDay; time += 0.25)
    ASSERT_DOUBLE_EQ(clock.fullFromTruncated(std::fmod(time, 512.0)), 20000.0 * kDay + time);
}

// The time of day starts at 0 at midnight, and so does what is left of it: 86400 is no multiple of 512.
TEST(DataClock, RebuildsTheTruncatedTimeOverMidnight) {
  DataClock clock(kNoon);
  clock.full(86390.0);
  double last = 20000.0 * kDay + 86390.0;
  for (double time = 86390.25; time < kDay + 1000.0; time += 0.25) {
    const double full = clock.fullFromTruncated(std::fmod(std::fmod(time, kDay), 512.0));
    ASSERT_DOUBLE_EQ(full, last + 0.25) << time;
    last = full;
  }
}

TEST(DataClock, FollowsTheTimeOfReceptionWhenItIsKnown) {
  DataClock clock(kNoon);
  clock.receiveAtTimeOfDay(66431.5);
  EXPECT_DOUBLE_EQ(clock.fullFromTruncated(std::fmod(66431.25, 512.0)), 20000.0 * kDay + 66431.25);
  clock.full(1000.0);  // some radar's clock is wrong
  EXPECT_DOUBLE_EQ(clock.fullFromTruncated(std::fmod(66432.0, 512.0)), 20000.0 * kDay + 66432.0);
}

TEST(DataClock, IsNotMovedByASingleWrongTime) {
  DataClock clock(kNoon);
  clock.full(40000.0);
  clock.full(50000.0);
  EXPECT_DOUBLE_EQ(clock.fullFromTruncated(std::fmod(40001.0, 512.0)), 20000.0 * kDay + 40001.0);
  clock.full(50000.0);
  clock.full(50001.0);
  EXPECT_DOUBLE_EQ(clock.fullFromTruncated(std::fmod(50002.0, 512.0)), 20000.0 * kDay + 50002.0);
}

TEST(DataClock, LeavesAnUnknownTimeUnknown) {
  DataClock clock(kNoon);
  EXPECT_TRUE(std::isnan(clock.full(std::nan(""))));
  EXPECT_TRUE(std::isnan(clock.fullFromTruncated(std::nan(""))));
  EXPECT_DOUBLE_EQ(clock.full(43000.0), 20000.0 * kDay + 43000.0);
}

}  // namespace
}  // namespace asterix_bridge
