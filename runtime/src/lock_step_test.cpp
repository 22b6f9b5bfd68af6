#include <tws_runtime/lock_step.h>

#include <gtest/gtest.h>

#include <string>

namespace tws_runtime {
namespace {

using Commands = std::vector<std::string>;

ros::Time at(double seconds) { return ros::Time(seconds); }

// Live and offline agree only if the arrival within the latency makes no difference.
TEST(LockStep, ACommandTakesEffectAtItsStampPlusTheLatencyHoweverEarlyItCame) {
  LockStep<std::string> loop(ros::Duration(0.2));
  loop.sent(at(10.0));
  EXPECT_TRUE(loop.add(at(10.0), "a"));
  EXPECT_EQ(loop.takeDue(at(10.1)), Commands{});
  EXPECT_EQ(loop.takeDue(at(10.2)), Commands{"a"});
  EXPECT_EQ(loop.takeDue(at(10.3)), Commands{});
}

// If this fails, one bad stamp of a command ends the simulator.
TEST(LockStep, AStampAtTheEndOfTimeIsNotDue) {
  LockStep<std::string> loop(ros::Duration(0.2));
  loop.add(ros::TIME_MAX, "a");
  EXPECT_EQ(loop.takeDue(at(10.0)), Commands{});
}

TEST(LockStep, CommandsTakeEffectInTheOrderOfTheirStamps) {
  LockStep<std::string> loop(ros::Duration(0.0));
  loop.add(at(2.0), "second");
  loop.add(at(1.0), "first");
  EXPECT_EQ(loop.takeDue(at(3.0)), (Commands{"first", "second"}));
}

TEST(LockStep, AStepWaitsForTheAnswersThatItGoesByAndForNoOthers) {
  LockStep<std::string> loop(ros::Duration(0.1));
  loop.sent(at(1.0));
  loop.sent(at(1.1));
  EXPECT_TRUE(loop.isReady(at(1.05)));
  EXPECT_FALSE(loop.isReady(at(1.1)));
  loop.add(at(1.0), "");
  EXPECT_TRUE(loop.isReady(at(1.1)));
  EXPECT_FALSE(loop.isReady(at(1.2)));
}

// A lost answer must not hold up a loop that goes on.
TEST(LockStep, AnAnswerSettlesTheReportsBeforeItToo) {
  LockStep<std::string> loop(ros::Duration(0.0));
  for (const double time : {1.0, 2.0, 3.0}) loop.sent(at(time));
  loop.add(at(2.0), "");
  EXPECT_TRUE(loop.isReady(at(2.9)));
  EXPECT_FALSE(loop.isReady(at(3.0)));
}

// Without a tracker the radar would otherwise crawl on at one step a time-out.
TEST(LockStep, AfterAWaitInVainNothingIsWaitedForUntilAnAnswerComesAgain) {
  LockStep<std::string> loop(ros::Duration(0.0));
  loop.sent(at(1.0));
  loop.stopWaiting();
  loop.sent(at(2.0));
  EXPECT_TRUE(loop.isReady(at(9.0)));
  loop.add(at(2.0), "");
  loop.sent(at(3.0));
  EXPECT_FALSE(loop.isReady(at(9.0)));
}

TEST(LockStep, ALateCommandIsSaidToBeLateAndTakesEffectAtTheNextStep) {
  LockStep<std::string> loop(ros::Duration(0.1));
  loop.takeDue(at(1.1));
  EXPECT_FALSE(loop.add(at(1.0), "late"));
  EXPECT_TRUE(loop.add(at(1.1), "in time"));
  EXPECT_EQ(loop.takeDue(at(1.2)), (Commands{"late", "in time"}));
}

// A database that is older than the one in force would turn the radar back.
TEST(LockStep, ACommandOlderThanOneInForceIsIgnored) {
  LockStep<std::string> loop(ros::Duration(0.0));
  loop.add(at(2.0), "new");
  loop.takeDue(at(2.0));
  EXPECT_FALSE(loop.add(at(1.0), "old"));
  EXPECT_EQ(loop.takeDue(at(3.0)), Commands{});
}

// 0.1 s and 0.3 s are no whole numbers of binary fractions; a command a nanosecond late would cost a whole period.
TEST(LockStep, ForgivesTheRoundingOfTimesOnAGrid) {
  LockStep<std::string> loop(ros::Duration(0, 100000001));
  EXPECT_TRUE(loop.add(at(1.0), "a"));
  EXPECT_EQ(loop.takeDue(ros::Time(1, 100000000)), Commands{"a"});
}

}  // namespace
}  // namespace tws_runtime
