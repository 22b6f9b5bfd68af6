#include "track_window.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <tws_core/angles.h>
#include <tws_core/geometry.h>
#include <tws_core/random_test_helpers.h>

namespace range_gate_tracker {
namespace {

const PlotSigmas kSigmas{100.0, 0.005};

WindowParams worst(double speed, double acceleration) {
  WindowParams params;
  params.greatest_speed = speed;
  params.greatest_acceleration = acceleration;
  params.window_sigmas = 3.0;
  return params;
}

tws::Plot plotAt(double range, double azimuth, double snr = tws::Plot::kUnknown) {
  tws::Plot plot;
  plot.range = range;
  plot.azimuth = azimuth;
  plot.snr = snr;
  return plot;
}

// 300 m/s and 20 m/s² for 6 s: 1800 m + 360 m, and three errors of 100 m; at 43.2 km seen under arcsin(0.05).
TEST(AcquisitionWindow, HasTheSizeWorkedOutByHand) {
  const WindowSize size = acquisitionSize(43200.0, 6.0, kSigmas, worst(300.0, 20.0));
  EXPECT_NEAR(size.range, 2460.0, 1e-9);
  EXPECT_NEAR(size.azimuth, 0.0500208568057700 + 0.015, 1e-12);
}

// If this fails, the fastest target is lost on its second scan (Henery 1985, section 2.4.2).
TEST(AcquisitionWindow, HoldsEveryTargetThatManoeuvresAtItsGreatestSpeedAndAcceleration) {
  auto generator = tws::seededGenerator();
  const WindowParams params = worst(350.0, 15.0);
  for (int i = 0; i < 100000; ++i) {
    const double range = tws::uniform(generator, 100.0, 2e5), azimuth = tws::uniform(generator, 0.0, tws::kTwoPi);
    const double course = tws::uniform(generator, 0.0, tws::kTwoPi), pull = tws::uniform(generator, 0.0, tws::kTwoPi);
    const double dt = tws::uniform(generator, 1.0, 12.0);
    const Eigen::Vector2d later = tws::planarFromPolar(range, azimuth) + tws::planarFromPolar(350.0 * dt, course) +
                                  tws::planarFromPolar(7.5 * dt * dt, pull);
    const WindowSize size = acquisitionSize(range, dt, kSigmas, params);
    TrackWindow window;
    window.range = range;
    window.azimuth = azimuth;
    window.half_range = size.range;
    window.half_azimuth = size.azimuth;
    // Nearer than a scan's way no window can hold it: it may come from anywhere.
    if (size.azimuth >= params.widest) continue;
    ASSERT_TRUE(window.contains(plotAt(later.norm(), tws::azimuthOf(later)))) << range << ' ' << dt;
  }
}

TEST(AcquisitionWindow, IsNeverWiderThanTheWidest) {
  EXPECT_EQ(acquisitionSize(500.0, 6.0, kSigmas, worst(300.0, 20.0)).azimuth, tws::radians(60.0));
}

// Errors of 200 m and 300 m (rms), three of them; 900 m at 30 km.
TEST(TrackingWindow, FollowsTheFiltersErrorByHand) {
  const WindowSize size = trackingSize(30000.0, 6.0, kSigmas, {200.0 * 200.0, 300.0 * 300.0}, 0, worst(300.0, 20.0));
  EXPECT_NEAR(size.range, 600.0, 1e-9);
  EXPECT_NEAR(size.azimuth, std::asin(0.03), 1e-12);
}

TEST(TrackingWindow, ShrinksNoFurtherThanTwoMeasurementsDiffer) {
  const WindowSize size = trackingSize(30000.0, 6.0, kSigmas, {0.0, 0.0}, 0, worst(300.0, 20.0));
  EXPECT_NEAR(size.range, 3.0 * std::sqrt(2.0) * 100.0, 1e-9);
  EXPECT_NEAR(size.azimuth, std::asin(3.0 * std::sqrt(2.0) * 0.005), 1e-12);
}

TEST(TrackingWindow, GrowsWithEachMissAndNeverBeyondTheAcquisitionWindow) {
  const WindowParams params = worst(300.0, 20.0);
  const PredictionError error{200.0 * 200.0, 300.0 * 300.0};
  EXPECT_NEAR(trackingSize(30000.0, 12.0, kSigmas, error, 1, params).range, 1200.0, 1e-9);
  const WindowSize most = acquisitionSize(30000.0, 6.0, kSigmas, params);
  EXPECT_EQ(trackingSize(30000.0, 6.0, kSigmas, {1e12, 1e12}, 0, params).range, most.range);
  EXPECT_EQ(trackingSize(30000.0, 6.0, kSigmas, {1e12, 1e12}, 0, params).azimuth, most.azimuth);
}

TEST(PredictionError, MovesTowardsEachSquaredErrorByItsWeight) {
  PredictionError error{1000.0, 0.0};
  WindowKinematics predicted;
  predicted.range = 10000.0;
  predicted.azimuth = tws::kTwoPi - 0.01;
  learnError(error, plotAt(10200.0, 0.01), predicted, 0.25);  // across north: 0.02 rad
  EXPECT_NEAR(error.range, 1000.0 + 0.25 * (40000.0 - 1000.0), 1e-9);
  EXPECT_NEAR(error.across, 0.25 * 204.0 * 204.0, 1e-6);
}

TEST(Window, HoldsWhatLiesInItAlsoAcrossNorth) {
  TrackWindow window;
  window.range = 20000.0;
  window.half_range = 500.0;
  window.azimuth = 0.01;
  window.half_azimuth = 0.05;
  EXPECT_TRUE(window.contains(plotAt(20400.0, tws::kTwoPi - 0.03)));
  EXPECT_FALSE(window.contains(plotAt(20400.0, tws::kTwoPi - 0.05)));
  EXPECT_FALSE(window.contains(plotAt(20600.0, 0.01)));
}

// Amplitudes 10 and 1 (20 dB apart): the centre lies at a eleventh of the way.
TEST(CentreOfGravity, IsWeightedByAmplitudeAndGoesAcrossNorth) {
  const tws::Plot centre = resolved({plotAt(10000.0, 0.011, 30.0), plotAt(11100.0, tws::kTwoPi - 0.011, 10.0)}, {},
                                    Ambiguity::kCentreOfGravity);
  EXPECT_NEAR(centre.range, 10100.0, 1e-9);
  EXPECT_NEAR(centre.azimuth, 0.009, 1e-12);
}

TEST(CentreOfGravity, IsTheMiddleWhenAnAmplitudeIsUnknown) {
  const tws::Plot centre =
      resolved({plotAt(10000.0, 1.0, 30.0), plotAt(11000.0, 1.2)}, {}, Ambiguity::kCentreOfGravity);
  EXPECT_NEAR(centre.range, 10500.0, 1e-9);
  EXPECT_NEAR(centre.azimuth, 1.1, 1e-12);
}

TEST(Nearest, IsMeasuredInHalfWindows) {
  TrackWindow window;
  window.range = 10000.0;
  window.half_range = 1000.0;
  window.azimuth = 1.0;
  window.half_azimuth = 0.1;
  // 0.5 half windows in range against 0.3 in azimuth.
  EXPECT_EQ(resolved({plotAt(10500.0, 1.0), plotAt(10000.0, 1.03)}, window, Ambiguity::kNearest).azimuth, 1.03);
}

}  // namespace
}  // namespace range_gate_tracker
