#include "random_group.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include <tws_core/units.h>

namespace radar_sim {
namespace {

RandomGroup traffic(long count) {
  RandomGroup group;
  group.name = "traffic";
  group.count = count;
  group.range = {10e3, 100e3};
  group.turning_fraction = 0.5;
  group.turn_rate = {tws::radians(1.0), tws::radians(3.0)};
  group.rebirth = true;
  group.keep_out = 5000.0;
  return group;
}

// Checks that "60 aircraft alive" is kept: completeness is counted over them.
TEST(RandomGroup, KeepsItsNumberAliveByRebirth) {
  const auto targets = drawGroup(traffic(20), 1, 0.0, 1000.0, 1900.0);
  EXPECT_GT(targets.size(), 20u);
  for (double time = 1000.0; time < 1900.0; time += 10.0) {
    int alive = 0;
    for (const Target& target : targets) alive += target.trajectory->existsAt(time);
    EXPECT_EQ(alive, 20) << time;
  }
}

// Slow ones circle in the disk for hours. If this fails, a run of a day loses them one by one beyond the horizon.
TEST(RandomGroup, ReplacesAlsoThoseThatLeaveAfterManyHours) {
  RandomGroup group = traffic(10);
  group.speed = {10.0, 20.0};
  group.turning_fraction = 1.0;
  for (const Target& target : drawGroup(group, 1, 0.0, 0.0, 86400.0)) {
    const double end = std::min(target.trajectory->spans().front().end, 86400.0);
    EXPECT_LE(target.trajectory->at(end).position.head<2>().norm(), 100e3 + 30.0) << target.name;
  }
}

TEST(RandomGroup, StaysWithinItsIntervals) {
  for (const Target& target : drawGroup(traffic(30), 2, 0.0, 1000.0, 1600.0)) {
    const TimeSpan span = target.trajectory->spans().front();
    EXPECT_GE(target.reflection.rcs, 2.0);
    EXPECT_LE(target.reflection.rcs, 10.0);
    for (double time = span.start; time < std::min(span.end, 1600.0); time += 1.0) {
      const TargetState state = target.trajectory->at(time);
      const double distance = state.position.head<2>().norm();
      EXPECT_GE(distance, 5000.0);
      EXPECT_LE(distance, 100e3 + 2.0);
      EXPECT_GE(state.velocity.head<2>().norm(), 100.0 - 1e-6);
      EXPECT_LE(state.velocity.head<2>().norm(), 300.0 + 1e-6);
      EXPECT_GE(state.height, 1000.0);
      EXPECT_LE(state.height, 12000.0);
    }
  }
}

TEST(RandomGroup, TurnsAboutTheShareThatIsAskedFor) {
  int turning = 0;
  const auto targets = drawGroup(traffic(400), 3, 0.0, 1000.0, 1001.0);
  for (const Target& target : targets) {
    const auto courseAt = [&](double time) {
      const Eigen::Vector3d velocity = target.trajectory->at(time).velocity;
      return std::atan2(velocity.x(), velocity.y());
    };
    bool turns = false;
    for (double time = 1000.0; time < 1400.0; time += 10.0)
      turns = turns || std::abs(courseAt(time) - courseAt(1000.0)) > 1e-6;
    turning += turns;
  }
  EXPECT_NEAR(turning, 200, 45);  // 4.5 standard deviations of the binomial, 10
}

// A user who asks for more aircraft, or a longer run, wants the others to fly as before.
TEST(RandomGroup, AddsTargetsWithoutChangingOthers) {
  const auto few = drawGroup(traffic(5), 7, 0.0, 1000.0, 1300.0);
  const auto many = drawGroup(traffic(9), 7, 0.0, 1000.0, 3000.0);
  for (const Target& target : few) {
    const auto same =
        std::find_if(many.begin(), many.end(), [&](const Target& other) { return other.name == target.name; });
    ASSERT_NE(same, many.end()) << target.name;
    const double time = target.trajectory->spans().front().start + 1.0;
    EXPECT_EQ(same->trajectory->at(time).position, target.trajectory->at(time).position) << target.name;
  }
}

TEST(RandomGroup, DiffersFromSeedToSeedAndNamesEachTargetOnce) {
  const auto one = drawGroup(traffic(20), 1, 0.0, 1000.0, 1600.0);
  const auto two = drawGroup(traffic(20), 2, 0.0, 1000.0, 1600.0);
  EXPECT_NE(one[0].trajectory->at(1000.0).position, two[0].trajectory->at(1000.0).position);
  std::set<std::string> names;
  for (const Target& target : one) EXPECT_TRUE(names.insert(target.name).second) << target.name;
}

// If this fails, clutter that should come and go stays, or is not there.
TEST(RandomGroup, IsThereDuringItsLifeOnly) {
  for (const bool rebirth : {true, false}) {
    RandomGroup group = traffic(10);
    group.rebirth = rebirth;
    group.life = {1100.0, 1240.0};
    const auto targets = drawGroup(group, 4, 0.0, 1000.0, 1600.0);
    const auto alive = [&](double time) {
      return std::count_if(targets.begin(), targets.end(),
                           [&](const Target& t) { return t.trajectory->existsAt(time); });
    };
    EXPECT_EQ(alive(1099.9), 0);
    EXPECT_EQ(alive(1100.1), 10);
    EXPECT_EQ(alive(1239.9), 10);
    EXPECT_EQ(alive(1240.1), 0);
  }
}

TEST(RandomGroup, RefusesAKeepOutThatNothingStaysOutOf) {
  RandomGroup group = traffic(1);
  group.keep_out = 200e3;
  EXPECT_THROW(drawGroup(group, 1, 0.0, 1000.0, 1100.0), std::invalid_argument);
}

}  // namespace
}  // namespace radar_sim
