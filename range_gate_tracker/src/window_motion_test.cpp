#include "window_motion.h"

#include <gtest/gtest.h>

#include <cmath>

#include "window_test_helpers.h"

namespace range_gate_tracker {
namespace {

WindowParams with(const std::string& kind, bool cartesian) {
  WindowParams params;
  params.filter.kind = kind;
  params.cartesian = cartesian;
  return params;
}

/// Greatest error of the predicted place on a flight past the radar at 10 km, after the first scans [m].
double worstPrediction(const WindowParams& params) {
  const WindowMotion motion(params);
  const Flight flight = straight(-30000.0, 10000.0, 250.0, 0.0);
  WindowMotion::State state = motion.start(TestRadar::plotAt(flight, 0.0));
  double worst = 0.0;
  for (double t = 6.0; t < 240.0; t += 6.0) {
    const double error = (motion.at(state, t).position - flight(t)).norm();
    if (t > 30.0) worst = std::max(worst, error);
    motion.update(state, TestRadar::plotAt(flight, t));
  }
  return worst;
}

// The pass-course effect (Henery 1985, section 3.2.2): straight flight accelerates in polar coordinates, v²/d at the
// closest point, 6.25 m/s² here; an α-β filter lags by aT²/β, 900 m with β = 0.25, in range alone.
TEST(PassCourse, LeavesFiltersInPolarCoordinatesBehindAndCartesianOnesUntouched) {
  EXPECT_LT(worstPrediction(with("alpha_beta", true)), 1e-6);
  EXPECT_GT(worstPrediction(with("alpha_beta", false)), 450.0);
  EXPECT_LT(worstPrediction(with("alpha_beta", false)), 3000.0);
}

TEST(WindowMotion, SaysTheSameInBothCoordinatesOfATargetFlyingOutwards) {
  for (bool cartesian : {true, false}) {
    const WindowParams params = with("alpha_beta", cartesian);
    const WindowMotion motion(params);
    const Flight flight = straight(3000.0, 4000.0, 60.0, 80.0);
    WindowMotion::State state = motion.start(TestRadar::plotAt(flight, 0.0));
    for (double t = 6.0; t < 100.0; t += 6.0) motion.update(state, TestRadar::plotAt(flight, t));
    const WindowKinematics k = motion.at(state, 100.0);
    EXPECT_NEAR(k.range, 15000.0, 1e-6) << cartesian;
    EXPECT_NEAR(k.range_rate, 100.0, 1e-6) << cartesian;
    EXPECT_NEAR(k.azimuth_rate, 0.0, 1e-9) << cartesian;
    EXPECT_NEAR(k.velocity.x(), 60.0, 1e-6) << cartesian;
    EXPECT_NEAR(k.position.y(), 12000.0, 1e-6) << cartesian;
  }
}

// 100 m/s along a circle of 20 km, clockwise through north: 0.005 rad/s.
TEST(WindowMotion, FollowsATargetAcrossNorthInPolarCoordinates) {
  const WindowParams params = with("alpha_beta", false);
  const WindowMotion motion(params);
  const Flight flight = [](double t) { return tws::planarFromPolar(20000.0, -0.2 + 0.005 * t); };
  WindowMotion::State state = motion.start(TestRadar::plotAt(flight, 0.0));
  for (double t = 6.0; t < 80.0; t += 6.0) motion.update(state, TestRadar::plotAt(flight, t));
  const WindowKinematics k = motion.at(state, 80.0);
  EXPECT_NEAR(k.azimuth, 0.2, 1e-9);
  EXPECT_NEAR(k.azimuth_rate, 0.005, 1e-9);
  EXPECT_NEAR(k.velocity.norm(), 100.0, 1e-6);
}

TEST(WindowMotion, TakesTheParametersForWhatADetectionDoesNotSay) {
  WindowParams params;
  params.range_sigma = 55.0;
  tws::Plot plot;
  EXPECT_EQ(sigmasOf(plot, params).range, 55.0);
  plot.range_sigma = 20.0;
  EXPECT_EQ(sigmasOf(plot, params).range, 20.0);
  plot.range_sigma = 0.0;  // no radar is that good
  EXPECT_EQ(sigmasOf(plot, params).range, 55.0);
}

}  // namespace
}  // namespace range_gate_tracker
