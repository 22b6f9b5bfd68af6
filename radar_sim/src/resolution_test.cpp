#include "resolution.h"

#include <gtest/gtest.h>

#include <tws_core/angles.h>
#include <tws_core/units.h>

namespace radar_sim {
namespace {

constexpr double kRangeCell = 300.0;
const double kAzimuthCell = tws::radians(3.0);

Echo echo(double time, double range, double azimuth_deg, double power) {
  return {time, range, tws::radians(azimuth_deg), power};
}

// Two aircraft that the radar cannot resolve give one plot between them: a tracker that never meets this is not tested.
TEST(Resolution, MergesEchoesOfOneCellAtTheirCentreOfPower) {
  std::vector<Echo> pending{echo(1.00, 50000.0, 10.0, 30.0), echo(1.01, 50200.0, 11.0, 10.0)};
  pending[0].range_error = 7.0;
  pending[1].range_error = -90.0;
  const auto resolved = resolve(pending, 1.005, kRangeCell, kAzimuthCell);
  ASSERT_EQ(resolved.size(), 1u);
  EXPECT_TRUE(pending.empty());
  EXPECT_DOUBLE_EQ(resolved[0].range, 50050.0);  // a quarter of the way
  EXPECT_NEAR(resolved[0].azimuth, tws::radians(10.25), 1e-12);
  EXPECT_NEAR(resolved[0].time, 1.0025, 1e-12);
  EXPECT_DOUBLE_EQ(resolved[0].power, 40.0);
  EXPECT_DOUBLE_EQ(resolved[0].range_error, 7.0);  // the stronger one's
}

TEST(Resolution, KeepsEchoesApartThatDifferByACellInRangeOrAzimuth) {
  std::vector<Echo> pending{echo(1.00, 50000.0, 10.0, 30.0), echo(1.00, 50300.0, 10.0, 30.0),
                            echo(1.05, 50000.0, 13.01, 30.0)};
  EXPECT_EQ(resolve(pending, 2.0, kRangeCell, kAzimuthCell).size(), 3u);
}

TEST(Resolution, MergesAcrossNorth) {
  std::vector<Echo> pending{echo(1.00, 50000.0, 359.5, 20.0), echo(1.02, 50000.0, 0.5, 20.0)};
  const auto resolved = resolve(pending, 2.0, kRangeCell, kAzimuthCell);
  ASSERT_EQ(resolved.size(), 1u);
  EXPECT_NEAR(tws::wrapPi(resolved[0].azimuth), 0.0, 1e-9);
}

TEST(Resolution, LeavesCellsOpenThatBeginLater) {
  std::vector<Echo> pending{echo(1.0, 50000.0, 10.0, 30.0), echo(2.0, 70000.0, 70.0, 30.0)};
  EXPECT_EQ(resolve(pending, 1.5, kRangeCell, kAzimuthCell).size(), 1u);
  EXPECT_EQ(pending.size(), 1u);
}

}  // namespace
}  // namespace radar_sim
