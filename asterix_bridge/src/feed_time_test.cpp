#include "feed_time.h"

#include <gtest/gtest.h>

namespace asterix_bridge {
namespace {

// A feed whose data are half a second old when they come, ten datagrams a second.
void play(FeedTime& time, double from, double to) {
  for (double wall = from; wall < to; wall += 0.1) time.add(wall - 0.5, wall);
}

TEST(FeedTime, GoesOnBetweenTheData) {
  FeedTime time;
  time.add(999.5, 1000.0);
  EXPECT_DOUBLE_EQ(time.at(1000.2), 999.7);
}

// If this fails, a stranger's plot closes the sectors of half a minute, and the picture is empty.
TEST(FeedTime, IsNotMovedByASingleDatagramFromAnotherTime) {
  FeedTime time;
  play(time, 1000.0, 1030.0);
  for (const double wrong : {40.0, -40.0, 7000.0}) {
    time.add(1030.0 + wrong, 1030.0);
    EXPECT_NEAR(time.at(1030.0), 1029.5, 1e-6) << wrong;
  }
}

TEST(FeedTime, FollowsAFeedThatJumps) {
  for (const double jump : {40.0, -40.0}) {
    FeedTime time;
    play(time, 1000.0, 1030.0);
    for (int i = 0; i < 8; ++i) time.add(1030.0 + jump + 0.1 * i, 1030.0 + 0.1 * i);
    EXPECT_NEAR(time.at(1031.0), 1031.0 + jump, 1e-6) << jump;
  }
}

// If this fails, the plots of a radar that sends them seconds after its marks are late for their sectors.
TEST(FeedTime, LearnsHowLateDataCome) {
  FeedTime time;
  play(time, 1000.0, 1030.0);
  EXPECT_NEAR(time.delay(), 0.0, 0.01);
  time.add(1030.0 - 5.5, 1030.0);
  EXPECT_NEAR(time.delay(), 0.0, 0.01);  // one is no habit
  for (double wall = 1030.0; wall < 1040.0; wall += 0.5) {
    time.add(wall - 0.5, wall);
    time.add(wall - 3.5, wall);
  }
  EXPECT_NEAR(time.delay(), 3.0, 0.01);
}

}  // namespace
}  // namespace asterix_bridge
