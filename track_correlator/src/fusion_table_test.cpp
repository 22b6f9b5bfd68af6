#include "fusion_table.h"

#include <gtest/gtest.h>

namespace track_correlator {
namespace {

using Outcome = FusionTable::Outcome;

constexpr std::int64_t kTurn = 64;

FusionTable tableWith(Scheme scheme = Scheme::kParallelCounter) {
  FusionParams params;
  params.scheme = scheme;
  return FusionTable(params);
}

/// Primary 70 and secondary 100 correlated in scans 1 to 10, as in the paper's example.
FusionTable tenScans() {
  FusionTable table = tableWith();
  for (int scan = 1; scan <= 10; ++scan) table.correlate(70, 100, scan * kTurn);
  return table;
}

// If these fail, pairs are confirmed too early, too late or for too long.

TEST(FusionTable, InitiatesWhenTheFusionCountExceedsTwo) {
  FusionTable table = tableWith();
  EXPECT_EQ(table.correlate(1, 2, 1 * kTurn), Outcome::kCounted);
  EXPECT_EQ(table.correlate(1, 2, 2 * kTurn), Outcome::kCounted);
  EXPECT_EQ(table.ofPrimary(1), nullptr);
  EXPECT_EQ(table.correlate(1, 2, 3 * kTurn), Outcome::kInitiated);
  ASSERT_NE(table.ofPrimary(1), nullptr);
  EXPECT_EQ(table.ofPrimary(1), table.ofSecondary(2));
  EXPECT_EQ(table.ofPrimary(1)->fusion_count, 3);
}

// Figure 6: n_sc = 10; the paper's example has n_fc = 10 after ten scans.
TEST(FusionTable, CountsScansAndFusions) {
  FusionTable table = tenScans();
  EXPECT_EQ(table.ofPrimary(70)->fusion_count, 10);
  EXPECT_EQ(table.ofPrimary(70)->last / kTurn, 10);
}

TEST(FusionTable, ForgetsACandidateAfterFiveScans) {
  FusionTable table = tableWith();
  table.correlate(1, 2, 1 * kTurn);
  table.correlate(1, 2, 2 * kTurn);
  EXPECT_EQ(table.correlate(1, 2, 7 * kTurn), Outcome::kCounted);
  EXPECT_EQ(table.correlate(1, 2, 8 * kTurn), Outcome::kCounted);
  EXPECT_EQ(table.correlate(1, 2, 9 * kTurn), Outcome::kInitiated);
}

TEST(FusionTable, SaysThatARowHasExpiredAfterFiveScans) {
  FusionTable table = tenScans();
  EXPECT_FALSE(table.expired(*table.ofPrimary(70), 14 * kTurn));
  EXPECT_TRUE(table.expired(*table.ofPrimary(70), 15 * kTurn));
}

// The paper's second scheme: three consecutive scans while the track coasts.
TEST(FusionTable, LetsANewSecondaryTakeOverInItsThirdConsecutiveScan) {
  FusionTable table = tenScans();
  EXPECT_FALSE(table.loseSecondary(100));
  EXPECT_EQ(table.correlate(70, 120, 11 * kTurn), Outcome::kCounted);
  EXPECT_EQ(table.correlate(70, 120, 12 * kTurn), Outcome::kCounted);
  EXPECT_EQ(table.correlate(70, 120, 13 * kTurn), Outcome::kTakenOver);
  EXPECT_EQ(table.ofPrimary(70)->secondary, 120U);
  EXPECT_EQ(table.ofSecondary(100), nullptr);
  EXPECT_EQ(table.ofSecondary(120), table.ofPrimary(70));
  EXPECT_EQ(table.ofPrimary(70)->fusion_count, 11);
}

TEST(FusionTable, BeginsTheParallelCountAnewAfterAGapOrAnotherRival) {
  FusionTable table = tenScans();
  table.loseSecondary(100);
  table.correlate(70, 120, 11 * kTurn);
  table.correlate(70, 120, 12 * kTurn);
  EXPECT_EQ(table.correlate(70, 130, 13 * kTurn), Outcome::kCounted);
  EXPECT_EQ(table.correlate(70, 120, 14 * kTurn), Outcome::kCounted);
  EXPECT_EQ(table.correlate(70, 120, 16 * kTurn), Outcome::kCounted);
  EXPECT_EQ(table.correlate(70, 120, 17 * kTurn), Outcome::kCounted);
  EXPECT_EQ(table.correlate(70, 120, 18 * kTurn), Outcome::kTakenOver);
}

TEST(FusionTable, LetsANewPrimaryTakeOverAsWell) {
  FusionTable table = tenScans();
  EXPECT_FALSE(table.losePrimary(70));
  for (int scan = 11; scan <= 13; ++scan) table.correlate(71, 100, scan * kTurn);
  ASSERT_NE(table.ofPrimary(71), nullptr);
  EXPECT_EQ(table.ofPrimary(71)->secondary, 100U);
  EXPECT_EQ(table.ofPrimary(70), nullptr);
}

TEST(FusionTable, RemovesARowThatHasLostBoth) {
  FusionTable table = tenScans();
  EXPECT_FALSE(table.losePrimary(70));
  EXPECT_TRUE(table.loseSecondary(100));
  EXPECT_EQ(table.rows(), 0U);
  EXPECT_TRUE(table.losePrimary(5)) << "nobody holds the place of a track without a row";
}

// Two rows that each have lost one track: the two that are left become one row.
TEST(FusionTable, JoinsTheRestsOfTwoRows) {
  FusionTable table = tenScans();
  for (int scan = 1; scan <= 10; ++scan) table.correlate(71, 101, scan * kTurn);
  table.loseSecondary(100);
  table.losePrimary(71);
  for (int scan = 11; scan <= 13; ++scan) table.correlate(70, 101, scan * kTurn);
  EXPECT_EQ(table.rows(), 1U);
  EXPECT_EQ(table.ofPrimary(70)->secondary, 101U);
}

TEST(ScansBetween, RoundsToWholeTurns) {
  EXPECT_EQ(scansBetween(100, 100 + 63), 1);
  EXPECT_EQ(scansBetween(100, 100 + 65), 1);
  EXPECT_EQ(scansBetween(100, 100 + 2 * 64 - 3), 2);
}

}  // namespace
}  // namespace track_correlator
