#include <tws_core/run_guard.h>

#include <gtest/gtest.h>

#include <vector>

namespace tws {
namespace {

using Verdict = RunGuard::Verdict;

constexpr double kDay = 86400.0;
constexpr double kStep = 0.1;  // from message to message [s]

/// A guard of some streams that have all run up to 100 s.
class RunGuardTest : public ::testing::Test {
 protected:
  RunGuard running(std::size_t streams) {
    RunGuard guard(streams, 5.0);
    for (double time = 98.0; time < 100.0; time += kStep)
      for (std::size_t stream = 0; stream < streams; ++stream) EXPECT_EQ(guard.judge(stream, time), Verdict::kTake);
    return guard;
  }

  /// What the guard says last of messages of these streams in turn, from `time` on, until it no longer holds them back
  /// or so many have come.
  static Verdict judgeRun(RunGuard& guard, const std::vector<std::size_t>& streams, double time, int messages) {
    for (int i = 0; i < messages; ++i)
      for (const std::size_t stream : streams) {
        const Verdict verdict = guard.judge(stream, time + kStep * i);
        if (verdict != Verdict::kHold) return verdict;
      }
    return Verdict::kHold;
  }
};

// If these fail, one bad stamp wipes the picture, or a bag played twice leaves tracks of the first time.

TEST_F(RunGuardTest, TakesWhatAdvancesAndWhatIsALittleLate) {
  RunGuard guard(2, 5.0);
  EXPECT_EQ(guard.judge(0, 100.0), Verdict::kTake);
  EXPECT_EQ(guard.judge(1, 101.0), Verdict::kTake);
  EXPECT_EQ(guard.judge(0, 96.5), Verdict::kTake);
}

TEST_F(RunGuardTest, OneStrayStampOfEitherSignDoesNoHarm) {
  for (const double stray : {100.0 - 6.0, 100.0 - kDay, 100.0 + 6.0, 100.0 + kDay}) {
    RunGuard guard = running(1);
    EXPECT_EQ(guard.judge(0, stray), Verdict::kHold);
    for (int i = 0; i < 30; ++i) EXPECT_EQ(guard.judge(0, 100.0 + kStep * i), Verdict::kTake) << stray;
  }
}

TEST_F(RunGuardTest, TwoStrayStampsThatAgreeDoNoHarmEither) {
  RunGuard guard = running(2);
  for (const std::size_t stream : {0u, 1u}) EXPECT_EQ(guard.judge(stream, 100.0 + kDay), Verdict::kHold);
  for (const std::size_t stream : {0u, 1u}) EXPECT_EQ(guard.judge(stream, 100.1), Verdict::kTake);
  EXPECT_EQ(guard.judge(0, 101.5 + kDay), Verdict::kHold) << "the first stray stamp is forgotten";
}

TEST_F(RunGuardTest, BeginsANewRunWhenMessagesOfASecondAgreeAndThenTakesTheOtherStreams) {
  RunGuard guard = running(2);
  EXPECT_EQ(judgeRun(guard, {0}, 1.0, 10), Verdict::kHold);
  EXPECT_EQ(guard.judge(1, 100.2), Verdict::kTake) << "still on its way";
  EXPECT_EQ(guard.judge(0, 2.05), Verdict::kHold) << "may be late data of this stream alone";
  EXPECT_EQ(guard.judge(1, 2.05), Verdict::kHold);
  EXPECT_EQ(guard.judge(0, 2.1), Verdict::kNewRun);
  EXPECT_TRUE(guard.agrees(1.0));
  EXPECT_FALSE(guard.agrees(100.2));
  EXPECT_EQ(guard.judge(1, 100.3), Verdict::kHold) << "of the old run";
  EXPECT_EQ(guard.judge(1, 2.1), Verdict::kTake);
}

TEST_F(RunGuardTest, OneStreamDoesNotDecideForTheOthers) {
  RunGuard guard = running(3);
  for (int i = 0; i < 300; ++i) {
    EXPECT_EQ(guard.judge(0, 1.0 + kStep * i), Verdict::kHold);
    for (const std::size_t stream : {1u, 2u}) EXPECT_EQ(guard.judge(stream, 100.0 + kStep * i), Verdict::kTake);
  }
}

TEST_F(RunGuardTest, MostStreamsDecide) {
  RunGuard guard = running(3);
  Verdict verdict = Verdict::kHold;
  for (int i = 0; i < 30 && verdict == Verdict::kHold; ++i) {
    EXPECT_EQ(guard.judge(2, 100.0 + kStep * i), Verdict::kTake);
    verdict = judgeRun(guard, {0, 1}, 1.0 + kStep * i, 1);
  }
  EXPECT_EQ(verdict, Verdict::kNewRun);
}

TEST_F(RunGuardTest, GoesOnBehindAPauseOfTheFeed) {
  RunGuard guard = running(1);
  EXPECT_EQ(judgeRun(guard, {0}, 1000.0, 5), Verdict::kHold);
  EXPECT_EQ(judgeRun(guard, {0}, 1000.5, 20), Verdict::kResume);
  EXPECT_EQ(guard.judge(0, 1001.2), Verdict::kTake);
}

TEST_F(RunGuardTest, WhatOneStreamHandsInLateAllAtOnceBeginsNoNewRun) {
  RunGuard guard = running(3);
  for (int i = 0; i < 190; ++i) EXPECT_EQ(guard.judge(0, 75.0 + kStep * i), Verdict::kHold);
  EXPECT_EQ(guard.judge(1, 100.1), Verdict::kTake);
  EXPECT_EQ(guard.judge(0, 100.1), Verdict::kTake);
}

TEST_F(RunGuardTest, FollowsAFeedWhoseMessagesLieFurtherApartThanTheLimit) {
  RunGuard guard(2, 5.0);  // a radar that turns once in ten minutes: its detections and its marks
  int held = 0;
  for (int i = 0; i < 100; ++i)
    for (const std::size_t stream : {0u, 1u}) held += guard.judge(stream, 9.4 * i) == Verdict::kHold ? 1 : 0;
  EXPECT_LE(held, 6);
}

TEST_F(RunGuardTest, GetsOverAStrayFirstStamp) {
  RunGuard guard(2, 5.0);
  EXPECT_EQ(guard.judge(0, 100.0 + kDay), Verdict::kTake);
  EXPECT_EQ(judgeRun(guard, {0, 1}, 100.0, 20), Verdict::kNewRun);
  EXPECT_EQ(judgeRun(guard, {0, 1}, 101.0, 20), Verdict::kTake);
}

}  // namespace
}  // namespace tws
