#include "flight_path.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <tws_core/angles.h>
#include <tws_core/units.h>

namespace radar_sim {
namespace {

PathStart northbound(double speed) {
  PathStart start;
  start.time = 1000.0;
  start.height = 5000.0;
  start.speed = speed;
  return start;
}

TEST(FlightPath, FliesStraightAndLevelWithoutLegs) {
  const FlightPath path(northbound(200.0), {}, 0.0);
  const TargetState state = path.at(1050.0);
  EXPECT_NEAR(state.position.x(), 0.0, 1e-9);
  EXPECT_NEAR(state.position.y(), 10000.0, 1e-9);
  EXPECT_DOUBLE_EQ(state.height, 5000.0);
  // At constant height it sinks below the map's plane: 10 km² / (2 · 6371 km) = 7.8 m.
  EXPECT_NEAR(state.position.z(), 5000.0 - 7.8, 0.1);
}

// By hand: 200 m/s at 3 °/s is a circle of 200 / 0.0523599 = 3819.7 m; after 30 s it has turned 90° right, to (R, R).
TEST(FlightPath, TurnsOnACircle) {
  const FlightPath path(northbound(200.0), {{30.0, tws::radians(3.0), 0.0, 0.0}}, 0.0);
  const TargetState state = path.at(1030.0);
  EXPECT_NEAR(state.position.x(), 3819.72, 0.01);
  EXPECT_NEAR(state.position.y(), 3819.72, 0.01);
  EXPECT_NEAR(state.velocity.x(), 200.0, 1e-9);
  EXPECT_NEAR(state.velocity.y(), 0.0, 1e-9);
  EXPECT_NEAR(path.at(1040.0).position.x(), 3819.72 + 2000.0, 0.01);  // straight on after the last leg
}

TEST(FlightPath, AcceleratesAndClimbs) {
  const FlightPath path(northbound(100.0), {{10.0, 0.0, 5.0, 20.0}}, 0.0);
  EXPECT_NEAR(path.at(1010.0).position.y(), 1250.0, 1e-9);  // 100 · 10 + 5 · 10² / 2
  EXPECT_NEAR(path.at(1010.0).velocity.y(), 150.0, 1e-9);
  EXPECT_NEAR(path.at(1010.0).height, 5200.0, 1e-9);
  EXPECT_NEAR(path.at(1005.0).velocity.z(), 20.0, 0.02);
}

// The velocity must be the position's derivative, or trackers' velocity errors are judged against a wrong truth. All
// motions at once.
TEST(FlightPath, HasTheDerivativeOfItsPositionAsVelocity) {
  PathStart start = northbound(150.0);
  start.position = {80e3, -60e3};
  start.course = 1.0;
  const FlightPath path(
      start, {{20.0, 0.0, 0.0, 0.0}, {30.0, tws::radians(-2.0), 3.0, 8.0}, {30.0, tws::radians(4.0), -2.0, -5.0}},
      100.0);
  for (const double time : {1005.0, 1025.0, 1049.0, 1051.0, 1075.0, 1100.0}) {
    const double h = 1e-3;
    const Eigen::Vector3d difference = (path.at(time + h).position - path.at(time - h).position) / (2.0 * h);
    EXPECT_NEAR((difference - path.at(time).velocity).norm(), 0.0, 1e-4) << time;
  }
}

TEST(FlightPath, IsContinuousFromLegToLeg) {
  const FlightPath path(northbound(150.0), {{20.0, tws::radians(3.0), 2.0, 5.0}, {20.0, tws::radians(-3.0), 0.0, 0.0}},
                        0.0);
  for (const double time : {1020.0, 1040.0}) {
    EXPECT_NEAR((path.at(time - 1e-7).position - path.at(time + 1e-7).position).norm(), 0.0, 1e-3);
  }
}

TEST(FlightPath, ExistsFromItsStartToItsEnd) {
  const FlightPath path(northbound(100.0), {}, 0.0, 1100.0);
  EXPECT_FALSE(path.existsAt(999.0));
  EXPECT_TRUE(path.existsAt(1000.0));
  EXPECT_FALSE(path.existsAt(1100.0));
  EXPECT_EQ(path.nextExistence(10.0), 1000.0);
  EXPECT_TRUE(std::isinf(path.nextExistence(1100.0)));
}

TEST(FlightPath, RefusesToFlyBackwards) {
  EXPECT_THROW(FlightPath(northbound(100.0), {{30.0, 0.0, -5.0, 0.0}}, 0.0), std::invalid_argument);
}

// If this fails, a target that flies straight on for a day has no height any more, and no truth message is usable.
TEST(FlightPath, EndsFarOutWhereTheMapsPlaneLosesTheEarth) {
  const FlightPath path(northbound(300.0), {}, 0.0);
  const double end = path.spans().front().end;
  EXPECT_NEAR(path.at(end).position.head<2>().norm(), 5.0e6, 1e-3);
  EXPECT_TRUE(path.at(end).position.allFinite());
}

TEST(FlightPath, LeavesADiskForGoodWhereItsLastStraightLegDoes) {
  PathStart start;
  start.time = 100.0;
  start.position = {-50e3, 30e3};
  start.course = tws::kPi / 2.0;
  start.speed = 100.0;
  const FlightPath path(start, {{10.0, 0.0, 0.0, 0.0}}, 0.0);
  EXPECT_DOUBLE_EQ(path.leavesForGood({0.0, 0.0}, 50e3), 100.0 + (50e3 + 40e3) / 100.0);
  EXPECT_DOUBLE_EQ(path.leavesForGood({0.0, 0.0}, 20e3), 110.0);      // It passes by.
  EXPECT_DOUBLE_EQ(path.leavesForGood({-100e3, 30e3}, 20e3), 110.0);  // It has left.
  start.speed = 0.0;
  EXPECT_EQ(FlightPath(start, {}, 0.0).leavesForGood({0.0, 0.0}, 60e3), std::numeric_limits<double>::infinity());
}

TEST(Waypoints, AreEachFlownOver) {
  const std::vector<Waypoint> points{{{0, 0}, 1000.0, 200.0},
                                     {{0, 30e3}, 3000.0, 200.0},
                                     {{25e3, 30e3}, 3000.0, 150.0},
                                     {{25e3, -10e3}, 500.0, 150.0}};
  PathStart start;
  start.time = 1000.0;
  const std::vector<Leg> legs = legsThrough(points, tws::radians(3.0), start);
  const FlightPath path(start, legs, 0.0);
  double time = start.time;
  std::size_t reached = 1;
  for (const Leg& leg : legs) {
    time += leg.duration;
    if (leg.turn_rate != 0.0) continue;  // straight legs end at a waypoint
    const TargetState state = path.at(time);
    EXPECT_NEAR((state.position.head<2>() - points[reached].position).norm(), 0.0, 1e-5) << reached;
    EXPECT_NEAR(state.height, points[reached].height, 1e-6);
    EXPECT_NEAR(state.velocity.head<2>().norm(), points[reached].speed, 1e-6);
    ++reached;
  }
  EXPECT_EQ(reached, points.size());
}

TEST(Waypoints, InsideTheTurningCircleAreRefused) {
  PathStart start;
  EXPECT_THROW(legsThrough({{{0, 0}, 0.0, 200.0}, {{0, 10e3}, 0.0, 200.0}, {{1000, 10e3}, 0.0, 200.0}},
                           tws::radians(1.0), start),
               std::invalid_argument);
  EXPECT_THROW(legsThrough({{{0, 0}, 0.0, 200.0}}, tws::radians(1.0), start), std::invalid_argument);
  EXPECT_THROW(legsThrough({{{0, 0}, 0.0, 200.0}, {{0, 0}, 0.0, 200.0}}, tws::radians(1.0), start),
               std::invalid_argument);
}

}  // namespace
}  // namespace radar_sim
