#include "target_type.h"

#include <gtest/gtest.h>

#include "window_test_helpers.h"

namespace range_gate_tracker {
namespace {

/// The type after each of so many detections.
std::vector<TargetType> typesOf(const Flight& flight, int detections) {
  const WindowParams params;
  std::vector<TargetType> types;
  TypeBaseline baseline;
  TargetType type = TargetType::kUnknown;
  for (int i = 0; i < detections; ++i)
    types.push_back(type = typeOf(type, baseline, TestRadar::plotAt(flight, 6.0 * i), params));
  return types;
}

TEST(TargetType, IsUnknownAfterOneDetection) {
  EXPECT_EQ(typesOf(straight(0.0, 20000.0, 200.0, 0.0), 1).back(), TargetType::kUnknown);
}

TEST(TargetType, TellsAircraftShipsAndRocksBySpeed) {
  EXPECT_EQ(typesOf(straight(0.0, 20000.0, 200.0, 0.0), 12).back(), TargetType::kAircraft);
  EXPECT_EQ(typesOf(straight(0.0, 5000.0, 25.0, 0.0), 12).back(), TargetType::kSurface);
  EXPECT_EQ(typesOf(straight(0.0, 20000.0, 0.0, 0.0), 12).back(), TargetType::kStationary);
}

// 100 km away the azimuth is good to 524 m: 200 m/s are more than three standard deviations of 741 m only after 14 s.
TEST(TargetType, WaitsUntilItIsSure) {
  const auto types = typesOf(straight(0.0, 100000.0, 200.0, 0.0), 6);
  EXPECT_EQ(types[1], TargetType::kStationary);  // 1200 m are less than 2222 m
  EXPECT_EQ(types[2], TargetType::kSurface);     // 2400 m - 2222 m: more than 10 m/s for 12 s, less than 40 m/s
  EXPECT_EQ(types[3], TargetType::kAircraft);    // 3600 m - 2222 m: more than 40 m/s for 18 s
}

// If this fails, an aircraft that waits for its landing in a holding pattern becomes a rock each round.
TEST(TargetType, StaysAnAircraftThatFliesCircles) {
  const Flight circle = [](double t) {
    return Eigen::Vector2d(3000.0 * std::cos(0.052 * t), 20000.0 + 3000.0 * std::sin(0.052 * t));
  };
  const auto types = typesOf(circle, 100);
  for (std::size_t i = 6; i < types.size(); ++i) EXPECT_EQ(types[i], TargetType::kAircraft) << i;
}

TEST(Priority, IsHighestForAircraftThatCouldSoonBeHere) {
  const WindowParams params;  // urgent_time 180 s
  WindowKinematics k;
  k.range = 30000.0;
  k.range_rate = -200.0;  // 150 s
  EXPECT_EQ(priorityOf(TargetType::kAircraft, k, params), 1);
  EXPECT_EQ(priorityOf(TargetType::kSurface, k, params), 3);
  EXPECT_EQ(priorityOf(TargetType::kStationary, k, params), 4);
  k.range_rate = -150.0;  // 200 s
  EXPECT_EQ(priorityOf(TargetType::kAircraft, k, params), 2);
  k.range_rate = 200.0;
  EXPECT_EQ(priorityOf(TargetType::kAircraft, k, params), 2);
}

}  // namespace
}  // namespace range_gate_tracker
