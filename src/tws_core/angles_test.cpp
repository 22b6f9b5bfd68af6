#include <tws_core/angles.h>

#include <gtest/gtest.h>

#include <limits>

#include <tws_core/random_test_helpers.h>

namespace tws {
namespace {

// An azimuth of exactly 2π would fall into sector 64, which does not exist.
TEST(WrapTwoPi, NeverReturnsAWholeTurn) {
  for (double angle : {-1e-17, -5e-324, -4e-16, kTwoPi, -kTwoPi, 2 * kTwoPi, -2 * kTwoPi, 1e6 * kTwoPi}) {
    EXPECT_GE(wrapTwoPi(angle), 0.0) << angle;
    EXPECT_LT(wrapTwoPi(angle), kTwoPi) << angle;
  }
  EXPECT_EQ(wrapTwoPi(kTwoPi), 0.0);
  EXPECT_EQ(wrapTwoPi(-1e-17), 0.0);
}

TEST(WrapTwoPi, LeavesAnglesInRangeUntouched) {
  for (double angle : {0.0, 1e-300, kPi, std::nextafter(kTwoPi, 0.0)}) EXPECT_EQ(wrapTwoPi(angle), angle);
}

TEST(WrapTwoPi, TakesQuarterTurnsToTheirPlaces) {
  EXPECT_DOUBLE_EQ(wrapTwoPi(-kPi / 2), 1.5 * kPi);
  EXPECT_DOUBLE_EQ(wrapTwoPi(2.5 * kPi), 0.5 * kPi);
  EXPECT_DOUBLE_EQ(wrapTwoPi(-3.5 * kPi), 0.5 * kPi);
}

// The sense of "half a turn" must be one: a target due astern may not flip between +180° and -180°.
TEST(WrapPi, CountsHalfATurnAsPositive) {
  EXPECT_EQ(wrapPi(kPi), kPi);
  EXPECT_EQ(wrapPi(-kPi), kPi);
  EXPECT_EQ(wrapPi(3 * kPi), kPi);
  EXPECT_EQ(wrapPi(-3 * kPi), kPi);
  EXPECT_LT(wrapPi(std::nextafter(kPi, 4.0)), 0.0);
}

TEST(Wrap, KeepsTheDirectionOfAnyAngle) {
  auto generator = seededGenerator();
  for (int i = 0; i < 100000; ++i) {
    const double angle = uniform(generator, -1.0, 1.0) * (i % 2 == 0 ? 20.0 : 1e5);
    for (double wrapped : {wrapTwoPi(angle), wrapPi(angle)}) {
      EXPECT_NEAR(std::sin(wrapped), std::sin(angle), 1e-10) << angle;
      EXPECT_NEAR(std::cos(wrapped), std::cos(angle), 1e-10) << angle;
    }
    EXPECT_TRUE(wrapTwoPi(angle) >= 0.0 && wrapTwoPi(angle) < kTwoPi) << angle;
    EXPECT_TRUE(wrapPi(angle) > -kPi && wrapPi(angle) <= kPi) << angle;
  }
}

// A bad azimuth must stay visible as NaN, not become a plausible direction.
TEST(Wrap, PassesOnWhatIsNoAngleAsNaN) {
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(std::isnan(wrapTwoPi(bad)));
    EXPECT_TRUE(std::isnan(wrapPi(bad)));
  }
}

// Without it a track that crosses north loses its detection, which seems 360° away.
TEST(AngularDifference, CrossesNorthTheShortWay) {
  EXPECT_NEAR(angularDifference(0.01, kTwoPi - 0.02), 0.03, 1e-15);
  EXPECT_NEAR(angularDifference(kTwoPi - 0.02, 0.01), -0.03, 1e-15);
  EXPECT_EQ(angularDifference(0.0, kPi), kPi);
}

}  // namespace
}  // namespace tws
