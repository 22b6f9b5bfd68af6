#include "backlog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace tws_runtime {
namespace {

class BacklogTest : public ::testing::Test {
 protected:
  /// A message has come; it is handed over at once unless it is kept.
  void send(std::size_t topic, double stamp) {
    const auto give = [this, topic, stamp] { given.emplace_back(stamp, topic); };
    backlog.beat(wall);
    if (!backlog.keep(topic, stamp, wall, give)) give();
  }
  /// The node goes on for so long.
  void run(double seconds) {
    for (const double end = wall + seconds; wall < end; wall += 0.01) {
      backlog.beat(wall);
      while (const auto give = backlog.take(wall)) (*give)();
    }
  }
  /// Both topics in step, the second one a second behind.
  void runInStep(double from, double to) {
    for (double stamp = from; stamp < to; stamp += 0.1) {
      send(0, stamp);
      send(1, stamp - 1.0);
      run(0.1);
    }
  }

  double wall = 1000.0;
  Backlog backlog;
  const std::size_t topics[2] = {backlog.addTopic(), backlog.addTopic()};
  std::vector<std::pair<double, std::size_t>> given;
};

TEST_F(BacklogTest, NothingIsKeptOfANodeThatRuns) {
  runInStep(0.0, 20.0);
  send(0, 30.0);
  EXPECT_EQ(given.back().first, 30.0);
}

// If this fails, a tracker that was stopped for a while finds the marks of that while too late, and loses its tracks.
TEST_F(BacklogTest, WhatCameTopicByTopicIsHandedOverInOrderOfTime) {
  runInStep(0.0, 20.0);
  given.clear();
  wall += 30.0;
  for (int i = 0; i < 300; ++i) send(0, 20.0 + 0.1 * i);
  run(0.1);
  for (int i = 0; i < 300; ++i) send(1, 19.0 + 0.1 * i);
  EXPECT_TRUE(given.empty());
  run(0.1);
  send(0, 50.1);
  send(1, 49.1);  // as late as it usually is
  run(0.25);
  ASSERT_EQ(given.size(), 602u);
  EXPECT_TRUE(std::is_sorted(given.begin(), given.end()));
  runInStep(50.2, 51.0);
  EXPECT_EQ(given.size(), 618u) << "and then all goes on as before";
  EXPECT_EQ(backlog.size(), 0u);
}

TEST_F(BacklogTest, WhatComesWhileItIsHandedOverTakesItsPlace) {
  runInStep(0.0, 2.0);
  given.clear();
  wall += 1.0;
  send(0, 2.0);
  send(0, 2.2);
  wall += 0.4;
  (*backlog.take(wall))();
  send(1, 2.1);
  run(0.1);
  ASSERT_EQ(given.size(), 3u);
  EXPECT_EQ(given[1].first, 2.1);
}

TEST_F(BacklogTest, OldMessagesWithoutEndHoldNothingUpForLong) {
  runInStep(0.0, 2.0);
  wall += 1.0;
  for (int i = 0; i < 1000; ++i) {
    send(0, 100.0 + 0.01 * i);
    send(1, 3.0 + 0.01 * i);
    run(0.01);
  }
  run(0.2);
  EXPECT_EQ(backlog.size(), 0u);
  EXPECT_GT(given.size(), 1900u);
}

/// The node runs on while nothing comes: its network has failed.
class SilenceTest : public BacklogTest {
 protected:
  SilenceTest() {
    runInStep(0.0, 20.0);
    given.clear();
    run(20.0);
  }
  /// What a topic has sent since, all at once.
  void comeBack(std::size_t topic, double to) {
    const double lag = topic == 0 ? 0.0 : 1.0;
    for (double stamp = 20.0; stamp < to; stamp += 0.1) send(topic, stamp - lag);
  }
};

// If this fails, a tracker behind a network that failed takes one topic's share of that time for all there was, and
// loses its tracks.
TEST_F(SilenceTest, TopicsThatComeBackOneAfterTheOtherAreHandedOverInOrderOfTime) {
  comeBack(0, 45.0);
  run(1.5);
  EXPECT_TRUE(given.empty());
  comeBack(1, 46.5);
  run(0.1);
  EXPECT_EQ(given.size(), 250u + 265u);
  EXPECT_TRUE(std::is_sorted(given.begin(), given.end()));
  EXPECT_EQ(backlog.size(), 0u);
  given.clear();
  runInStep(46.5, 47.0);
  EXPECT_EQ(given.size(), 10u) << "and then all goes on as before";
}

TEST_F(SilenceTest, APauseOfAllIsOverInAMoment) {
  send(0, 20.0);
  send(1, 19.0);
  run(0.25);
  EXPECT_TRUE(given.empty());
  run(0.1);
  EXPECT_EQ(given.size(), 2u);
}

TEST_F(SilenceTest, ATopicThatStaysAwayHoldsTheOthersUpForFiveSeconds) {
  comeBack(0, 45.0);
  for (int i = 0; i < 49; ++i) {
    send(0, 45.0 + 0.1 * i);
    run(0.1);
  }
  EXPECT_TRUE(given.empty());
  run(0.2);
  EXPECT_EQ(given.size(), 250u + 49u);
  send(0, 50.0);
  EXPECT_EQ(given.size(), 300u) << "and no more";
}

TEST_F(BacklogTest, ATopicThatIsSeldomHeardIsNotMissed) {
  for (int i = 0; i < 20; ++i) {
    send(0, 8.0 * i);
    run(8.0);
  }
  send(0, 160.0);
  EXPECT_EQ(given.size(), 21u);
  EXPECT_EQ(backlog.size(), 0u);
}

}  // namespace
}  // namespace tws_runtime
