#include <tws_core/tick_clock.h>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include <tws_core/random_test_helpers.h>

namespace tws {
namespace {

TEST(ModuloArithmetic, WorksAcrossTheWrapAsTheReportAsks) {
  EXPECT_EQ(moduloDifference(5, 32765), 8);
  EXPECT_EQ(moduloDifference(32765, 5), -8);
  EXPECT_EQ(moduloDifference(100, 40), 60);
  EXPECT_EQ(moduloSum(32765, 8), 5);
  EXPECT_EQ(moduloSum(5, -8), 32765);
}

TEST(ModuloArithmetic, CountsHalfACycleAsForward) {
  EXPECT_EQ(moduloDifference(16384, 0), 16384);
  EXPECT_EQ(moduloDifference(0, 16384), 16384);
  EXPECT_EQ(moduloDifference(0, 16385), 16383);
  EXPECT_EQ(moduloDifference(16385, 0), -16383);
}

TEST(CountFromSeconds, CountsWholeTicksAndWrapsAfter262Seconds) {
  EXPECT_EQ(countFromSeconds(0.0), 0);
  EXPECT_EQ(countFromSeconds(0.0079), 0);
  EXPECT_EQ(countFromSeconds(0.0081), 1);
  EXPECT_EQ(countFromSeconds(262.144), 0);
  EXPECT_EQ(countFromSeconds(262.143), 32767);
  EXPECT_EQ(countFromSeconds(-0.001), 32767);
}

// A tick lost to rounding is 8 ms of wrong time in every velocity.
TEST(CountFromSeconds, GivesBackEveryTickOfAnHourAndOfAYear) {
  for (int tick = 0; tick < 450000; ++tick) ASSERT_EQ(countFromSeconds(tick * 0.008), tick % 32768);
  constexpr std::int64_t kYear = 3942000000;
  for (std::int64_t tick = kYear; tick < kYear + 1000; ++tick) {
    ASSERT_EQ(countFromSeconds(static_cast<double>(tick) * 0.008), tick % 32768);
  }
}

TEST(CountFromSeconds, RefusesWhatIsNoTime) {
  EXPECT_THROW(countFromSeconds(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  EXPECT_THROW(countFromSeconds(1e300), std::invalid_argument);
}

TEST(TickClock, StartsAtTheFirstCountAndRunsOnPastTheWrap) {
  TickClock clock;
  EXPECT_DOUBLE_EQ(clock.seconds(32000), 256.0);
  EXPECT_DOUBLE_EQ(clock.seconds(32767), 262.136);
  EXPECT_DOUBLE_EQ(clock.seconds(0), 262.144);
  EXPECT_DOUBLE_EQ(clock.seconds(32767), 262.136);  // and back
  clock.reset();
  EXPECT_DOUBLE_EQ(clock.seconds(125), 1.0);
}

// After the clock's first wrap, 4.4 minutes into a run, a wrong unwrapping drops every track.
TEST(TickClock, FollowsRandomStepsOfEitherSignUpToHalfTheCycle) {
  auto generator = seededGenerator();
  TickClock clock;
  std::int64_t truth = 1000;
  clock.seconds(1000);
  for (int i = 0; i < 100000; ++i) {
    truth += uniformInt(generator, -16383, 16384);
    const int count = static_cast<int>(((truth % 32768) + 32768) % 32768);
    ASSERT_DOUBLE_EQ(clock.seconds(count), static_cast<double>(truth) * 0.008);
  }
}

TEST(TickClock, RefusesACountOutsideFifteenBitsAndKeepsItsState) {
  TickClock clock;
  clock.seconds(10);
  EXPECT_THROW(clock.seconds(32768), std::invalid_argument);
  EXPECT_THROW(clock.seconds(-1), std::invalid_argument);
  EXPECT_DOUBLE_EQ(clock.seconds(135), 1.08);
}

}  // namespace
}  // namespace tws
