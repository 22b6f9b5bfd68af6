#include "code_history.h"

#include <gtest/gtest.h>

#include <cmath>

namespace track_correlator {
namespace {

constexpr double kClimb = 75.0;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::uint16_t after(std::initializer_list<CodeReply> replies) {
  CodeHistory history;
  for (const CodeReply& reply : replies) history.take(reply, 3);
  return history.value();
}

// If these fail, a track shows a code that its aircraft does not have.

TEST(CodeHistory, KnowsNothingBeforeTheFirstCleanReply) {
  EXPECT_EQ(after({}), kNoCode);
  EXPECT_EQ(after({{04321, true}, {kNoCode, false}}), kNoCode);
}

TEST(CodeHistory, TakesTheFirstCleanReply) { EXPECT_EQ(after({{07777, true}, {04321, false}}), 04321); }

TEST(CodeHistory, HoldsItsCodeThroughGarbledAndMissingReplies) {
  EXPECT_EQ(after({{04321, false}, {07777, true}, {07777, true}, {07777, true}, {kNoCode, false}}), 04321);
}

TEST(CodeHistory, ChangesWhenANewCodeHasComeThreeTimesInARow) {
  EXPECT_EQ(after({{04321, false}, {01000, false}, {01000, false}}), 04321);
  EXPECT_EQ(after({{04321, false}, {01000, false}, {01000, false}, {01000, false}}), 01000);
}

TEST(CodeHistory, CountsAnewWhenTheOldCodeOrAThirdOneComesInBetween) {
  EXPECT_EQ(after({{04321, false}, {01000, false}, {01000, false}, {04321, false}, {01000, false}}), 04321);
  EXPECT_EQ(after({{04321, false}, {01000, false}, {01000, false}, {02000, false}, {01000, false}}), 04321);
}

TEST(HeightHistory, FollowsAClimb) {
  HeightHistory history;
  EXPECT_TRUE(std::isnan(history.value()));
  history.take(3000.0, false, 0.0, kClimb);
  history.take(3100.0, false, 8.0, kClimb);
  EXPECT_EQ(history.value(), 3100.0);
}

TEST(HeightHistory, HoldsBackAJumpUntilTheNextReplyAgrees) {
  HeightHistory history;
  history.take(3000.0, false, 0.0, kClimb);
  history.take(9000.0, false, 8.0, kClimb);  // 750 m/s
  EXPECT_EQ(history.value(), 3000.0);
  history.take(9010.0, false, 16.0, kClimb);
  EXPECT_EQ(history.value(), 9010.0);
}

TEST(HeightHistory, ForgetsAJumpThatTheNextReplyDeniesAndIgnoresGarbledOnes) {
  HeightHistory history;
  history.take(3000.0, false, 0.0, kClimb);
  history.take(9000.0, false, 8.0, kClimb);
  history.take(3000.0, false, 16.0, kClimb);
  history.take(9000.0, false, 24.0, kClimb);
  history.take(3010.0, true, 32.0, kClimb);
  history.take(kNaN, false, 32.0, kClimb);
  EXPECT_EQ(history.value(), 3000.0);
}

}  // namespace
}  // namespace track_correlator
