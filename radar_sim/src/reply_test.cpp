#include "reply.h"

#include <gtest/gtest.h>

namespace radar_sim {
namespace {

constexpr double kGrid = 1.45e-6;

// A secondary tracker must tell garbled codes from good ones, and mend them: they must look as garbled codes do.
TEST(OverlaidReplies, AddTheirPulsesWhenTheyComeTogether) {
  EXPECT_EQ(overlaid(01200, 04321, 0.0), 05321);
  EXPECT_EQ(overlaid(01200, 04321, 0.2e-6), 05321);
}

TEST(OverlaidReplies, LeaveEachOtherAloneBetweenThePositions) {
  EXPECT_EQ(overlaid(01200, 07777, kGrid / 2.0), 01200);
  EXPECT_EQ(overlaid(01200, 07777, -0.3e-6), 01200);
}

// Own positions: F1 0, C1 1, A1 2, C2 3, A2 4, C4 5, A4 6, X 7, B1 8, D1 9, B2 10, D2 11, B4 12, D4 13, F2 14.
TEST(OverlaidReplies, ShiftByWholePositions) {
  EXPECT_EQ(overlaid(0, 0, kGrid), 00010);       // its F1 falls on C1, its F2 beyond the own F2
  EXPECT_EQ(overlaid(0, 01000, kGrid), 00030);   // its A1 falls on C2 as well
  EXPECT_EQ(overlaid(0, 0, -kGrid), 00004);      // its F2 falls on D4
  EXPECT_EQ(overlaid(0, 04000, kGrid), 00010);   // its A4 falls on X
  EXPECT_EQ(overlaid(0, 0, 14 * kGrid), 0);      // framing pulse on framing pulse
  EXPECT_EQ(overlaid(0, 0, 13 * kGrid), 00004);  // its F1 falls on D4
  EXPECT_EQ(overlaid(0, 07777, 15 * kGrid), 0);  // after the own reply
}

// 20.3 µs and 0.45 µs at the speed of light, there and back.
TEST(GarbleRegion, IsAsLongAsAReply) {
  EXPECT_NEAR(kGarbleRange / 1852.0, 1.643, 0.001);
  EXPECT_NEAR(kReplyResolution, 67.45, 0.01);
}

TEST(ReadCode, NeedsEnoughReplies) {
  EXPECT_FALSE(readCode({}, 1).code);
  EXPECT_FALSE(readCode({{01234, false}}, 2).code);
  EXPECT_FALSE(readCode({{01234, true}}, 2).garbled);
  const CodeReading reading = readCode({{01234, false}, {01234, false}}, 2);
  EXPECT_EQ(reading.code, 01234);
  EXPECT_FALSE(reading.garbled);
}

TEST(ReadCode, PrefersRepliesThatNothingOverlapped) {
  const CodeReading reading =
      readCode({{07777, true}, {07777, true}, {07777, true}, {01234, false}, {01234, false}}, 2);
  EXPECT_EQ(reading.code, 01234);
  EXPECT_FALSE(reading.garbled);
}

TEST(ReadCode, SaysWhenTheCodeIsNotToBeTrusted) {
  const CodeReading all = readCode({{05321, true}, {05321, true}, {01234, false}}, 2);
  EXPECT_EQ(all.code, 05321);
  EXPECT_TRUE(all.garbled);
  const CodeReading two = readCode({{05321, false}, {05321, false}, {01234, false}}, 2);
  EXPECT_EQ(two.code, 05321);
  EXPECT_TRUE(two.garbled);
}

}  // namespace
}  // namespace radar_sim
