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

}  // namespace
}  // namespace tws_runtime
