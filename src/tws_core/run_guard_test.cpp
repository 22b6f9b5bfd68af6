#include <tws_core/run_guard.h>

#include <gtest/gtest.h>

#include <limits>
#include <optional>
#include <vector>

namespace tws {
namespace {

using Standing = RunGuard::Standing;
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

// If these fail, a node that stood still for a while (its streams then come one after the other) forgets all, or one
// radar's clock ends the tracks of the others.

TEST_F(RunGuardTest, ABacklogIsWorkedOff) {
  RunGuard guard = running(2);
  for (int i = 0; i < 3000; ++i) ASSERT_EQ(guard.judge(0, 100.0 + kStep * i), Verdict::kTake);
  for (int i = 0; i < 3000; ++i) {
    ASSERT_EQ(guard.judge(1, 100.0 + kStep * i), Verdict::kTake) << i;
    ASSERT_EQ(guard.standing(1), i < 2949 ? Standing::kLagging : Standing::kInLine) << i;
  }
}

/// Two radars of two streams each, abreast up to 100 s.
class TwoSources : public RunGuardTest {
 protected:
  explicit TwoSources(double skew_limit = std::numeric_limits<double>::infinity()) : guard(0, 5.0, skew_limit) {
    for (const std::size_t first : {0u, 2u}) {
      guard.addStream();
      guard.addStream(guard.sourceOf(first));
    }
    go(200);
  }
  /// Both go on for so many messages, the first `off` from the other; how many of its messages are taken.
  int go(int messages, double off = 0.0, std::optional<double> clock_off = {}) {
    int taken = 0;
    for (int i = 0; i < messages; ++i) {
      now += kStep;
      const auto clock = clock_off ? std::optional<double>(now + *clock_off) : std::nullopt;
      for (const std::size_t stream : {0u, 1u}) {
        const Verdict verdict = guard.judge(stream, now + off, clock);
        taken += verdict != Verdict::kHold ? 1 : 0;
        changes += verdict == Verdict::kNewRun || verdict == Verdict::kResume ? 1 : 0;
      }
      for (const std::size_t stream : {2u, 3u}) healthy += guard.judge(stream, now, clock) == Verdict::kTake ? 0 : 1;
    }
    return taken;
  }

  double now = 80.0;
  RunGuard guard;
  int changes = 0;
  int healthy = 0;  // messages of the other radar that were not taken
};

TEST_F(TwoSources, OnesClockDoesNotTouchTheOtherUntilItAgreesAgain) {
  for (const double off : {-3600.0, 3600.0, -30.0, 6.0}) {
    EXPECT_EQ(go(1000, off), 0) << off;
    EXPECT_EQ(guard.standing(0), Standing::kSetAside) << off;
    EXPECT_EQ(guard.standing(2), Standing::kInLine) << off;
    EXPECT_EQ(go(100), 200) << off;
    EXPECT_EQ(guard.standing(0), Standing::kInLine) << off;
    EXPECT_EQ(changes + healthy, 0) << off;
  }
}

TEST_F(TwoSources, AStoppedClockIsSetAside) {
  for (double time = 100.0; time < 110.0; time += kStep) {
    EXPECT_EQ(guard.judge(0, 0.0), Verdict::kHold);
    EXPECT_EQ(guard.judge(2, time), Verdict::kTake);
  }
  EXPECT_EQ(guard.standing(0), Standing::kSetAside);
}

TEST_F(TwoSources, StreamsOfOneSourceHaveOneVoteAndNoneAgainstTheirOwn) {
  for (double time = 100.0; time < 200.0; time += kStep) {
    EXPECT_EQ(guard.judge(0, time - 90.0), Verdict::kHold);
    EXPECT_EQ(guard.judge(1, time), Verdict::kTake);
  }
}

TEST_F(TwoSources, OneDecidesAloneOnlyWhenTheOtherHasBeenSilentForLong) {
  for (double time = 0.0; time < 59.0; time += kStep) ASSERT_EQ(guard.judge(0, time), Verdict::kHold);
  EXPECT_EQ(judgeRun(guard, {0}, 59.0, 20), Verdict::kNewRun);
}

TEST_F(TwoSources, TheClockDecidesWhenTheTwoDisagree) {
  go(100, -3600.0, 0.0);
  EXPECT_EQ(changes, 0) << "the clock is with the run";
  go(100, -3600.0, -3600.0);
  EXPECT_EQ(changes, 1) << "the clock is with the one that went back";
  EXPECT_EQ(guard.standing(2), Standing::kSetAside);
}

TEST_F(TwoSources, BothTogetherBeginANewRun) {
  for (double time = 1.0; time < 3.0; time += kStep)
    for (const std::size_t stream : {0u, 1u, 2u, 3u})
      changes += guard.judge(stream, time, time) == Verdict::kNewRun ? 1 : 0;
  EXPECT_EQ(changes, 1);
  for (const std::size_t stream : {0u, 1u, 2u, 3u}) EXPECT_EQ(guard.standing(stream), Standing::kInLine);
}

/// The same, where more than a second out of step is too much.
class TwoSourcesInStep : public TwoSources {
 protected:
  TwoSourcesInStep() : TwoSources(1.0) {}
};

TEST_F(TwoSourcesInStep, AStepOfSecondsIsSetAsideAndAHalfIsNot) {
  EXPECT_EQ(go(100, 0.5), 200);
  EXPECT_EQ(go(100), 200);
  for (const double off : {3.0, -3.0}) {
    EXPECT_EQ(go(100, off), 0) << off;
    EXPECT_EQ(guard.standing(0), Standing::kSetAside) << off;
    EXPECT_EQ(go(100), 200) << off;
  }
  EXPECT_EQ(changes + healthy, 0);
}

TEST_F(TwoSourcesInStep, APauseOfSecondsOfOneOrOfBothIsNoStep) {
  for (int i = 0; i < 30; ++i) EXPECT_EQ(guard.judge(2, now += kStep), Verdict::kTake);
  EXPECT_EQ(go(70), 140) << "one was silent";
  now += 3.0;
  go(70);
  EXPECT_EQ(changes, 1) << "both were";
  EXPECT_EQ(guard.standing(0), Standing::kInLine);
  EXPECT_EQ(guard.standing(2), Standing::kInLine);
}

// If this fails, a bag that someone plays into a live graph is taken for one that begins anew, or nobody learns of it.
TEST_F(TwoSources, ASecondPublisherIsLeftOutAndNamed) {
  for (double time = 100.0; time < 106.0; time += kStep) {
    EXPECT_EQ(guard.judge(0, time - 80.0), Verdict::kHold);
    EXPECT_EQ(guard.standing(0) == Standing::kRivalled, time > 100.15) << time;
    EXPECT_EQ(guard.judge(0, time), Verdict::kTake);
    EXPECT_EQ(guard.judge(2, time), Verdict::kTake);
  }
}

}  // namespace
}  // namespace tws
