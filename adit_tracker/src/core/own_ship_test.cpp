#include "core/own_ship.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <tws_core/units.h>

namespace adit_tracker {
namespace {

/// North at 10 m/s, turning right by 2°/s, through 360°.
OwnShip sailed(double to) {
  OwnShip ship;
  for (double time = 0.0; time <= to; time += 1.0)
    EXPECT_EQ(ship.add(time, {0.0, 10.0 * time, tws::radians(350.0 + 2.0 * time)}), "");
  return ship;
}

// If these fail, plots are turned by a pose of another time, or by one that nobody measured.
TEST(OwnShip, BetweenPosesItMovesStraightAndTurnsTheShorterWay) {
  const OwnShip ship = sailed(20.0);
  const auto pose = ship.at(7.25);
  ASSERT_TRUE(pose.has_value());
  EXPECT_NEAR(pose->y, 72.5, 1e-9);
  EXPECT_NEAR(tws::wrapTwoPi(pose->heading), tws::radians(4.5), 1e-9);
  OwnShip across;
  across.add(0.0, {0.0, 0.0, tws::radians(359.0)});
  across.add(1.0, {0.0, 0.0, tws::radians(1.0)});
  EXPECT_NEAR(tws::wrapPi(across.at(0.75)->heading), tws::radians(0.5), 1e-9);
}

TEST(OwnShip, BeyondThePosesItIsKnownForTwoSecondsOnly) {
  const OwnShip ship = sailed(20.0);
  EXPECT_NEAR(ship.at(21.5)->y, 215.0, 1e-9);
  EXPECT_NEAR(ship.at(-1.5)->y, -15.0, 1e-9);
  EXPECT_FALSE(ship.at(22.1).has_value());
  EXPECT_FALSE(ship.at(-2.1).has_value());
  EXPECT_FALSE(ship.over(21.0, 23.0).has_value());
  EXPECT_FALSE(OwnShip().at(0.0).has_value());
}

// If this fails, the error of a place, divided by a hundredth of a second, throws the ship away.
TEST(OwnShip, ItIsExtrapolatedByItsMotionOverASecond) {
  OwnShip ship;
  for (int i = 0; i <= 500; ++i) ship.add(0.01 * i, {i % 2 == 0 ? 0.5 : -0.5, 0.1 * i, 0.0});
  EXPECT_NEAR(ship.at(6.5)->y, 65.0, 0.2);
  EXPECT_NEAR(ship.at(6.5)->x, 0.5, 2.1);
  OwnShip twice;
  twice.add(0.0, {0.0, 0.0, 0.0});
  twice.add(1e-300, {10.0, 0.0, 0.0});
  EXPECT_EQ(twice.at(1.0)->x, 10.0);
}

TEST(OwnShip, NothingIsMadeUpInALongGap) {
  OwnShip ship = sailed(20.0);
  EXPECT_EQ(ship.add(29.0, {0.0, 290.0, 0.5}), "");
  EXPECT_NEAR(ship.at(25.0)->y, 250.0, 1e-9);
  EXPECT_EQ(ship.add(45.0, {0.0, 450.0, 0.5}), "");
  EXPECT_NEAR(ship.at(30.0)->y, 300.0, 1e-9);
  EXPECT_FALSE(ship.at(37.0).has_value());
  EXPECT_NEAR(ship.at(44.0)->y, 450.0, 1e-9) << "a single pose says nothing of its speed";
}

// If this fails, one bad fix of a receiver throws all plots to another place.
TEST(OwnShip, AJumpIsRefusedUntilThreePosesAgree) {
  OwnShip ship = sailed(20.0);
  EXPECT_EQ(ship.add(21.0, {5000.0, 210.0, 0.5}), "lies 5000 m and 1 deg from the one before, 1.00 s later");
  EXPECT_EQ(ship.add(22.0, {0.0, 220.0, 0.5}), "");
  EXPECT_EQ(ship.at(21.0)->x, 0.0);
  EXPECT_NE(ship.add(23.0, {5000.0, 230.0, 0.5}), "");
  EXPECT_NE(ship.add(24.0, {5000.0, 240.0, 0.5}), "");
  EXPECT_EQ(ship.add(25.0, {5000.0, 250.0, 0.5}), "");
  EXPECT_EQ(ship.at(23.5)->x, 0.0) << "extrapolated from before the jump";
  EXPECT_FALSE(ship.at(24.5) && std::abs(ship.at(24.5)->x - 2500.0) < 2000.0) << "not between the two";
  EXPECT_EQ(ship.add(26.0, {5000.0, 260.0, 0.5}), "");
  EXPECT_EQ(ship.at(25.5)->x, 5000.0);
  EXPECT_NE(ship.add(27.0, {5000.0, 270.0, 0.5 + tws::kPi}), "") << "the bow does not swing round in a second";
}

TEST(OwnShip, WhatIsNoNumberIsRefused) {
  OwnShip ship = sailed(3.0);
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  EXPECT_NE(ship.add(nan, {}), "");
  EXPECT_NE(ship.add(4.0, {nan, 0.0, 0.0}), "");
  EXPECT_NE(ship.add(4.0, {0.0, infinity, 0.0}), "");
  EXPECT_NE(ship.add(4.0, {0.0, 0.0, nan}), "");
  EXPECT_EQ(ship.size(), 4U);
}

// If this fails, a recording that is played again has no own ship from its second time on, or one late message ends it.
TEST(OwnShip, TimeThatBeginsAnewIsFollowedAndALateMessageIsNot) {
  OwnShip ship = sailed(100.0);
  EXPECT_EQ(ship.add(99.5, {0.0, 995.0, 0.0}), "does not come after the one before");
  EXPECT_EQ(ship.add(100.0, *ship.at(100.0)), "") << "the same again";
  EXPECT_EQ(ship.size(), 101U);
  EXPECT_NE(ship.add(0.0, {}), "");
  EXPECT_NE(ship.add(1.0, {0.0, 10.0, 0.0}), "");
  EXPECT_EQ(ship.add(2.0, {0.0, 20.0, 0.0}), "");
  EXPECT_EQ(ship.size(), 1U);
  EXPECT_EQ(ship.latest(), 2.0);
}

TEST(OwnShip, WhatIsForgottenIsBeforeThatTime) {
  OwnShip ship = sailed(100.0);
  ship.forgetBefore(50.5);
  EXPECT_NEAR(ship.at(50.5)->y, 505.0, 1e-9);
  EXPECT_EQ(ship.size(), 51U);
}

}  // namespace
}  // namespace adit_tracker
