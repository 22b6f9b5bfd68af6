#include "mode_c.h"

#include <gtest/gtest.h>

#include <bitset>
#include <cmath>

#include <tws_core/units.h>

namespace radar_sim {
namespace {

double feet(double value) { return tws::metresFromFeet(value); }

// Levels on the PPI, and the separation that a controller reads from them, would be wrong. Codes worked by hand from
// the rule of the appendix: Gray code of D2 D4 A1 A2 A4 B1 B2 B4 for 500 ft, C1 C2 C4 for what is left.
TEST(ModeC, HasTheCodesOfTheTable) {
  EXPECT_EQ(modeCCode(feet(-1000.0)), 00020);  // 0, C2
  EXPECT_EQ(modeCCode(feet(-900.0)), 00030);   // 0, C1 C2
  EXPECT_EQ(modeCCode(feet(-800.0)), 00010);   // 0, C1
  EXPECT_EQ(modeCCode(feet(-700.0)), 00410);   // 1: B4, C1
  EXPECT_EQ(modeCCode(feet(0.0)), 00620);      // 2: Gray 11, B2 B4, C2
  EXPECT_EQ(modeCCode(feet(100.0)), 00630);    // 2, C1 C2
  EXPECT_EQ(modeCCode(feet(300.0)), 00210);    // 3: Gray 10, B2; odd, so C1 first
  EXPECT_EQ(modeCCode(feet(30500.0)), 01020);  // 63: Gray 100000, A1, C2
}

TEST(ModeC, IsRoundedToTheNearestHundredFeet) {
  EXPECT_EQ(modeCCode(feet(149.0)), modeCCode(feet(100.0)));
  EXPECT_EQ(modeCCode(feet(151.0)), modeCCode(feet(200.0)));
}

// What the code is made for: on a step the encoder reads one height or the other, never a third.
TEST(ModeC, ChangesOnePulseFromStepToStep) {
  for (int hundreds = -10; hundreds < 1267; ++hundreds) {
    const auto below = modeCCode(feet(100.0 * hundreds)), above = modeCCode(feet(100.0 * (hundreds + 1)));
    ASSERT_TRUE(below && above) << hundreds;
    EXPECT_EQ(std::bitset<12>(*below ^ *above).count(), 1u) << hundreds;
  }
}

TEST(ModeC, IsReadBackAtEveryHeight) {
  for (int hundreds = -10; hundreds <= 1267; ++hundreds)
    EXPECT_NEAR(modeCHeight(modeCCode(feet(100.0 * hundreds)).value()).value(), feet(100.0 * hundreds), 1e-9);
}

// 1278 of the 4096 codes are heights; the others come from garbling, and must not be taken for some height.
TEST(ModeC, OtherCodesAreNoHeight) {
  int heights = 0;
  for (std::uint16_t code = 0; code < 010000; ++code) heights += modeCHeight(code).has_value();
  EXPECT_EQ(heights, 1278);
  EXPECT_FALSE(modeCHeight(0));
  EXPECT_FALSE(modeCHeight(00070));
  EXPECT_FALSE(modeCHeight(00621));  // with D1
}

TEST(ModeC, HasNoCodeOutsideItsHeights) {
  EXPECT_FALSE(modeCCode(feet(-1051.0)));
  EXPECT_FALSE(modeCCode(feet(126751.0)));
  EXPECT_FALSE(modeCCode(std::nan("")));
}

}  // namespace
}  // namespace radar_sim
