#include "transponder.h"

#include <gtest/gtest.h>

#include <set>

namespace radar_sim {
namespace {

Transponder allDrawn() {
  Transponder transponder;
  transponder.codes = {Transponder::kDrawn, Transponder::kDrawn, Transponder::kDrawn};
  return transponder;
}

TEST(Transponder, RepliesOnlyInItsModes) {
  Transponder transponder;
  transponder.codes[index(Mode::k3A)] = 07421;
  EXPECT_EQ(transponder.reply(Mode::k3A, 3000.0), 07421);
  EXPECT_FALSE(transponder.reply(Mode::k1, 3000.0));
  EXPECT_FALSE(transponder.reply(Mode::k2, 3000.0));
  EXPECT_FALSE(transponder.reply(Mode::kC, 3000.0));
  transponder.altitude = true;
  EXPECT_EQ(transponder.reply(Mode::kC, 0.0), 00620);
}

TEST(Transponder, IsSilentFromTheFirstInstantUpToTheLast) {
  Transponder transponder;
  transponder.silences = {{1010.0, 1020.0}};
  EXPECT_FALSE(transponder.isSilentAt(1009.9));
  EXPECT_TRUE(transponder.isSilentAt(1010.0));
  EXPECT_FALSE(transponder.isSilentAt(1020.0));
}

// A study that adds an aircraft must not give the others new codes.
TEST(DrawnCodes, DependOnTheSeedAndTheTargetsNameOnly) {
  const Transponder once = drawCodes(allDrawn(), 3, "alpha");
  EXPECT_EQ(once.codes, drawCodes(allDrawn(), 3, "alpha").codes);
  EXPECT_NE(once.codes, drawCodes(allDrawn(), 3, "bravo").codes);
  EXPECT_NE(once.codes, drawCodes(allDrawn(), 4, "alpha").codes);
  Transponder given = allDrawn();
  given.codes[index(Mode::k2)] = 00017;
  given = drawCodes(given, 3, "alpha");
  EXPECT_EQ(given.codes[index(Mode::k2)], 00017);
  EXPECT_EQ(given.codes[index(Mode::k3A)], once.codes[index(Mode::k3A)]);
}

TEST(DrawnCodes, LieWhereTheirModesAllow) {
  std::set<int> codes;
  for (int i = 0; i < 3000; ++i) {
    const Transponder drawn = drawCodes(allDrawn(), 1, "aircraft/" + std::to_string(i));
    EXPECT_EQ(drawn.codes[0] & ~kMode1Pulses, 0);
    EXPECT_GE(drawn.codes[2], 00001);
    EXPECT_LE(drawn.codes[2], 06777);
    codes.insert(drawn.codes[2]);
  }
  // 3000 draws of 3583: 3583 (1 - (1 - 1/3583)^3000) = 2032 different ones are expected, give or take 22.
  EXPECT_NEAR(static_cast<double>(codes.size()), 2032.0, 100.0);
}

TEST(DrawnTransponders, KeepTheirShares) {
  int replying = 0, military = 0;
  for (int i = 0; i < 4000; ++i) {
    const Transponder drawn = drawTransponder({0.8, 0.25}, 1, "aircraft/" + std::to_string(i));
    replying += drawn.reply(Mode::k3A, 0.0).has_value() && drawn.reply(Mode::kC, 0.0).has_value();
    military += drawn.reply(Mode::k1, 0.0).has_value() && drawn.reply(Mode::k2, 0.0).has_value();
  }
  EXPECT_NEAR(replying, 3200, 4.5 * 25.3);  // binomial: sqrt(4000 · 0.8 · 0.2)
  EXPECT_NEAR(military, 800, 4.5 * 25.3);
}

}  // namespace
}  // namespace radar_sim
