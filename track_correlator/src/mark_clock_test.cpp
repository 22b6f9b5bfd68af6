#include "mark_clock.h"

#include <gtest/gtest.h>

namespace track_correlator {
namespace {

// If one of these fails, sectors are correlated twice, or never.

std::vector<std::int64_t> numbersOf(const std::vector<Mark>& marks) {
  std::vector<std::int64_t> numbers;
  for (const Mark& mark : marks) numbers.push_back(mark.running);
  return numbers;
}

TEST(MarkClock, GivesEachMarkTheDelayLater) {
  MarkClock clock(2);
  EXPECT_TRUE(clock.add({7, 1.0}).due.empty());
  EXPECT_TRUE(clock.add({8, 1.1}).due.empty());
  const auto step = clock.add({9, 1.2});
  ASSERT_EQ(numbersOf(step.due), (std::vector<std::int64_t>{7}));
  EXPECT_EQ(step.due[0].time, 1.0);
}

TEST(MarkClock, FillsAGapAtEvenTimes) {
  MarkClock clock(0);
  clock.add({7, 1.0});
  const auto step = clock.add({10, 1.6});
  ASSERT_EQ(numbersOf(step.due), (std::vector<std::int64_t>{8, 9, 10}));
  EXPECT_EQ(step.lost, 2u);
  EXPECT_NEAR(step.due[0].time, 1.2, 1e-12);
  EXPECT_NEAR(step.due[1].time, 1.4, 1e-12);
}

TEST(MarkClock, LeavesOutOneNumberOutOfLine) {
  MarkClock clock(0);
  clock.add({7, 1.0});
  for (const std::int64_t stray : {7, 3, 100000}) {
    const auto step = clock.add({stray, 1.1});
    EXPECT_TRUE(step.stray) << stray;
    EXPECT_TRUE(step.due.empty()) << stray;
  }
  EXPECT_EQ(numbersOf(clock.add({8, 1.1}).due), (std::vector<std::int64_t>{8}));
}

TEST(MarkClock, CountsAnewWhenTwoNumbersOutOfLineAgree) {
  MarkClock clock(1);
  clock.add({500, 1.0});
  clock.add({501, 1.1});
  EXPECT_TRUE(clock.add({0, 2.0}).stray);
  const auto step = clock.add({1, 2.1});
  EXPECT_TRUE(step.restarted);
  EXPECT_TRUE(step.due.empty());
  EXPECT_EQ(numbersOf(clock.add({2, 2.2}).due), (std::vector<std::int64_t>{1}));
}

}  // namespace
}  // namespace track_correlator
