#include <tws_core/run_guard.h>

#include <gtest/gtest.h>

namespace tws {
namespace {

using Verdict = RunGuard::Verdict;

// If these fail, one bad stamp wipes the picture, or a bag played twice leaves tracks of the first time.

TEST(RunGuard, TakesWhatAdvancesAndWhatIsALittleLate) {
  RunGuard guard(2, 5.0);
  EXPECT_EQ(guard.judge(0, 100.0), Verdict::kTake);
  EXPECT_EQ(guard.judge(1, 101.0), Verdict::kTake);
  EXPECT_EQ(guard.judge(0, 96.5), Verdict::kTake);
}

TEST(RunGuard, RefusesOneMadStampOfEitherSign) {
  RunGuard guard(1, 5.0);
  guard.judge(0, 100.0);
  EXPECT_EQ(guard.judge(0, 0.0), Verdict::kMad);
  EXPECT_EQ(guard.judge(0, 100.1), Verdict::kTake);
  EXPECT_EQ(guard.judge(0, 5000.0), Verdict::kMad);
  EXPECT_EQ(guard.judge(0, 100.2), Verdict::kTake);
  EXPECT_EQ(guard.judge(0, 0.0), Verdict::kMad) << "the first stray is forgotten";
}

TEST(RunGuard, BeginsANewRunWhenTwoAgreeAndRefusesTheRestOfTheOldOne) {
  RunGuard guard(2, 5.0);
  guard.judge(0, 100.0);
  guard.judge(1, 100.0);
  EXPECT_EQ(guard.judge(0, 1.0), Verdict::kMad);
  EXPECT_EQ(guard.judge(0, 1.1), Verdict::kNewRun);
  EXPECT_EQ(guard.judge(1, 100.1), Verdict::kOldRun);
  EXPECT_EQ(guard.judge(1, 100.2), Verdict::kOldRun);
  EXPECT_EQ(guard.judge(1, 1.2), Verdict::kTake);
  EXPECT_EQ(guard.judge(0, 1.3), Verdict::kTake);
}

TEST(RunGuard, GoesOnBehindAPauseOfTheFeed) {
  RunGuard guard(1, 5.0);
  guard.judge(0, 100.0);
  EXPECT_EQ(guard.judge(0, 130.0), Verdict::kTake);
  EXPECT_EQ(guard.judge(0, 1000.0), Verdict::kMad);
  EXPECT_EQ(guard.judge(0, 1000.1), Verdict::kTake);
}

}  // namespace
}  // namespace tws
