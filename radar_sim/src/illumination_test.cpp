#include "illumination.h"

#include <gtest/gtest.h>

namespace radar_sim {
namespace {

constexpr double kBeam = 0.04;  // [rad]

/// Four interrogations from the first one on, all of them replied to in mode 3/A.
Illumination aircraft(double time, double range, double azimuth, Code code, std::int64_t first = 0) {
  Illumination it;
  it.time = time;
  it.range = range;
  it.azimuth = azimuth;
  it.codes[index(Mode::k3A)] = code;
  it.first_interrogation = first;
  it.received = {true, true, true, true};
  return it;
}

TEST(Illumination, RepliesToItsInterrogationsInItsModes) {
  Illumination it = aircraft(0.0, 50e3, 1.0, 01234, 10);
  it.received[1] = false;
  EXPECT_FALSE(it.reply(9, Mode::k3A));
  EXPECT_EQ(it.reply(10, Mode::k3A), 01234);
  EXPECT_FALSE(it.reply(11, Mode::k3A));
  EXPECT_FALSE(it.reply(12, Mode::kC));
  EXPECT_FALSE(it.reply(14, Mode::k3A));
}

TEST(ReplyGroups, HoldWhatCannotBeToldApartAndWhatGarblesIt) {
  std::deque<Illumination> all{aircraft(0.00, 50e3, 1.00, 01),    aircraft(0.01, 50.06e3, 1.03, 02),
                               aircraft(0.02, 50.07e3, 1.00, 03), aircraft(0.03, 53e3, 1.00, 04),
                               aircraft(0.04, 53.05e3, 1.00, 05), aircraft(0.05, 50e3, 1.05, 06)};
  const auto group = takeGroup(all, 1.0, kBeam);
  ASSERT_TRUE(group);
  ASSERT_EQ(group->members.size(), 2u);
  EXPECT_EQ(group->members[1], &all[1]);
  ASSERT_EQ(group->others.size(), 3u);  // not the one beyond 3043 m
  EXPECT_EQ(group->others[0], &all[2]);
  EXPECT_EQ(group->others[1], &all[3]);
  EXPECT_EQ(group->others[2], &all[5]);  // the same range, but another azimuth: a plot of its own
}

TEST(ReplyGroups, AreTakenOnceAndInTime) {
  std::deque<Illumination> all{aircraft(0.0, 50e3, 1.0, 01), aircraft(0.2, 90e3, 1.2, 02)};
  EXPECT_TRUE(takeGroup(all, 0.1, kBeam));
  EXPECT_FALSE(takeGroup(all, 0.1, kBeam));
  EXPECT_TRUE(takeGroup(all, 0.3, kBeam));
}

// Only replies to the same interrogation meet.
TEST(DecodedReplies, AreGarbledByThoseToTheSameInterrogationOnly) {
  const Illumination own = aircraft(0.0, 50e3, 1.0, 01200, 0), other = aircraft(0.01, 51e3, 1.0, 04321, 2);
  const ReplyGroup group{{&own}, {&other}};
  EXPECT_FALSE(decodeReply(group, 1, Mode::k3A)->garbled);
  EXPECT_EQ(decodeReply(group, 1, Mode::k3A)->code, 01200);
  EXPECT_TRUE(decodeReply(group, 2, Mode::k3A)->garbled);
  EXPECT_FALSE(decodeReply(group, 5, Mode::k3A));
  EXPECT_FALSE(decodeReply(group, 2, Mode::kC));
}

}  // namespace
}  // namespace radar_sim
