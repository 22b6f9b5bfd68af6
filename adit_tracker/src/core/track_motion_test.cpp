#include "core/track_motion.h"

#include <gtest/gtest.h>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>

#include "core/plot_test_helpers.h"

namespace adit_tracker {
namespace {

RadarQuality quality() {
  RadarParams radar;
  radar.range_sigma = 100.0;
  radar.azimuth_sigma = 0.003;
  return RadarQuality(radar, false);
}

/// The report's smoothing filter, eqs. (1) to (6), as printed but for the readings that tws_core/alpha_beta.h states.
struct ReportFilter {
  tws::AdaptiveAlphaBetaParams params;
  double xs, vs = 0.0, p1 = 0.0, p2 = 0.0, last = 0.0;
  bool first = true;

  void update(double error, double T1) {
    if (!first) {
      p1 = std::exp(-params.omega_a * T1) * p1 + (1.0 - std::exp(-params.omega_a * T1)) * error * last;
      p2 = std::exp(-params.omega_b * T1) * p2 + (1.0 - std::exp(-params.omega_b * T1)) * error * error;
    }
    const double omega0 =
        first ? params.omega_max : std::clamp(0.5 * std::abs(p1 / p2), params.omega_min, params.omega_max);
    const double xi = params.damping, omega_d = omega0 * std::sqrt(1.0 - xi * xi);
    const double alpha = 1.0 - std::exp(-2.0 * xi * omega0 * T1);
    const double beta =
        1.0 + std::exp(-2.0 * xi * omega0 * T1) - 2.0 * std::exp(-xi * omega0 * T1) * std::cos(omega_d * T1);
    xs = xs + vs * T1 + alpha * error;
    vs += beta / T1 * error;
    last = error;
    first = false;
  }
};

class AlphaBetaMotion : public testing::Test {
 protected:
  AditParams params_ = AditParams::named("nrl7952");
  TrackMotion motion_{params_};
  Track track_;
};

TEST_F(AlphaBetaMotion, StartsAtRestWhereThePlotIs) {
  motion_.start(track_, plotAt(100.0, 50e3, 1.0), quality());
  const Kinematics later = motion_.at(track_, 130.0).kinematics;
  EXPECT_DOUBLE_EQ(later.range, 50e3);
  EXPECT_DOUBLE_EQ(later.azimuth, 1.0);
  EXPECT_DOUBLE_EQ(later.range_rate, 0.0);
  EXPECT_DOUBLE_EQ(later.azimuth_rate, 0.0);
  EXPECT_DOUBLE_EQ(track_.first_time, 100.0);
  EXPECT_EQ(track_.updates, 1);
}

// If this fails, `nrl7952` does not smooth as the report does.
TEST_F(AlphaBetaMotion, SmoothsRangeAndAzimuthByTheReportsEquations) {
  auto generator = tws::seededGenerator();
  ReportFilter range{params_.alpha_beta, 80e3}, azimuth{params_.alpha_beta, 3.0};
  motion_.start(track_, plotAt(0.0, 80e3, 3.0), quality());
  double time = 0.0;
  for (int k = 0; k < 40; ++k) {
    const double T1 = tws::uniform(generator, 0.5, 8.0);
    time += T1;
    const double r = 80e3 - 200.0 * time + tws::uniform(generator, -200.0, 200.0);
    const double a = 3.0 + 0.001 * time + tws::uniform(generator, -0.01, 0.01);
    range.update(r - (range.xs + range.vs * T1), T1);
    azimuth.update(a - (azimuth.xs + azimuth.vs * T1), T1);
    motion_.update(track_, plotAt(time, r, a), quality());
    // The gains come from a table in steps of ω₀T₁ of 1/1024: alpha is off by at most 0.09 %.
    ASSERT_NEAR(track_.smoothed.range, range.xs, 5.0);
    ASSERT_NEAR(track_.smoothed.azimuth, azimuth.xs, 2e-4);
    ASSERT_NEAR(track_.smoothed.range_rate, range.vs, 2.0);
    ASSERT_NEAR(track_.smoothed.azimuth_rate, azimuth.vs, 5e-5);
    ASSERT_DOUBLE_EQ(track_.smoothed.time, time);
  }
}

// If this fails, a track that crosses north is thrown half way round the picture.
TEST_F(AlphaBetaMotion, SmoothsAcrossNorth) {
  motion_.start(track_, plotAt(0.0, 50e3, -0.02), quality());
  for (int k = 1; k <= 10; ++k) motion_.update(track_, plotAt(6.0 * k, 50e3, -0.02 + 0.006 * k), quality());
  EXPECT_NEAR(tws::wrapPi(track_.smoothed.azimuth), 0.04, 0.005);
  EXPECT_NEAR(track_.smoothed.azimuth_rate, 0.001, 2e-4);
  EXPECT_NEAR(motion_.at(track_, 70.0).kinematics.azimuth, 0.05, 0.006);
}

// Near a crossing of two beams, plots come in the wrong order: T1 = 0 moves nothing.
TEST_F(AlphaBetaMotion, GivesNoWeightToAPlotThatIsOlderThanTheTrack) {
  motion_.start(track_, plotAt(0.0, 50e3, 1.0), quality());
  motion_.update(track_, plotAt(6.0, 50.6e3, 1.0), quality());
  const Kinematics before = track_.smoothed;
  motion_.update(track_, plotAt(5.9, 70e3, 1.1), quality());
  EXPECT_DOUBLE_EQ(track_.smoothed.range, before.range);
  EXPECT_DOUBLE_EQ(track_.smoothed.range_rate, before.range_rate);
  EXPECT_DOUBLE_EQ(track_.smoothed.time, 6.0);
  EXPECT_DOUBLE_EQ(track_.last_update, 6.0);
}

TEST_F(AlphaBetaMotion, PredictsByTheSmoothedVelocities) {
  motion_.start(track_, plotAt(0.0, 50e3, 1.0), quality());
  motion_.update(track_, plotAt(6.0, 50.6e3, 1.006), quality());
  motion_.predict(track_, 1, 11.0, quality());
  const Kinematics& k = track_.smoothed;
  EXPECT_DOUBLE_EQ(track_.predicted.range, k.range + 5.0 * k.range_rate);
  EXPECT_DOUBLE_EQ(track_.predicted.azimuth, k.azimuth + 5.0 * k.azimuth_rate);
  EXPECT_DOUBLE_EQ(track_.predicted.time, 11.0);
  EXPECT_EQ(track_.predicted.radar, 1U);
}

class TurningMotion : public testing::Test {
 protected:
  TrackMotion motion_{AditParams::named("default")};
  Track track_;

  /// A flight along y = `abeam` to the east, 250 m/s, over x = 0 at t = 0, seen every 4 s without errors.
  void fly(double abeam, double from, double to) {
    for (double t = from; t <= to; t += 4.0) {
      const tws::Plot plot = plotAt(t, std::hypot(250.0 * t, abeam), std::atan2(250.0 * t, abeam));
      if (t == from) {
        motion_.start(track_, plot, quality());
      } else {
        motion_.update(track_, plot, quality());
      }
    }
  }
};

// The pass-course effect: straight flight past the radar looks like acceleration in range and azimuth.
// If this fails, aircraft are lost when they pass near the site.
TEST_F(TurningMotion, PassesTheRadarWithoutLag) {
  fly(5e3, -160.0, 40.0);
  const Kinematics k = track_.smoothed;
  EXPECT_NEAR(k.x, 10e3, 20.0);
  EXPECT_NEAR(k.y, 5e3, 20.0);
  EXPECT_NEAR(k.vx, 250.0, 3.0);
  EXPECT_NEAR(k.vy, 0.0, 3.0);
}

TEST_F(TurningMotion, PolarAndPlanarStateAgree) {
  fly(20e3, -100.0, 20.0);
  const Extrapolation e = motion_.at(track_, 24.0);
  const Kinematics &k = e.kinematics, next = motion_.at(track_, 24.01).kinematics;
  EXPECT_NEAR(k.range, std::hypot(k.x, k.y), 1e-6);
  EXPECT_NEAR(k.range * std::sin(k.azimuth), k.x, 1e-6);
  EXPECT_NEAR(k.range * std::cos(k.azimuth), k.y, 1e-6);
  EXPECT_NEAR((next.range - k.range) / 0.01, k.range_rate, 0.1);
  EXPECT_NEAR((next.azimuth - k.azimuth) / 0.01, k.azimuth_rate, 1e-5);
  EXPECT_TRUE(e.has_covariance);
}

// If this fails, gates point in a wrong direction: long in range where they should be long across.
TEST_F(TurningMotion, TheInnovationIsInRangeAndCrossRange) {
  motion_.start(track_, plotAt(0.0, 100e3, 0.7), quality());
  motion_.predict(track_, 0, 0.0, quality());
  const tws::Symmetric2& s = track_.predicted.innovation;
  EXPECT_NEAR(s.xx, 2.0 * 100.0 * 100.0, 1.0);  // The track's own error and the radar's.
  EXPECT_NEAR(s.yy, 2.0 * 300.0 * 300.0, 1.0);
  EXPECT_NEAR(s.xy, 0.0, 1.0);
  EXPECT_NEAR(track_.predicted.log_volume, std::log(4.0), 1e-4);
}

// If this fails, clutter becomes firm tracks, or aircraft stay tentative.
TEST_F(TurningMotion, TellsWhatMovesFromWhatStandsStill) {
  motion_.start(track_, plotAt(0.0, 50e3, 1.0), quality());
  for (int k = 1; k <= 5; ++k) motion_.update(track_, plotAt(4.0 * k, 50e3, 1.0), quality());
  EXPECT_LT(track_.fixed.moving_evidence, 0.0);
  Track flying;
  motion_.start(flying, plotAt(0.0, 50e3, 1.0), quality());
  for (int k = 1; k <= 5; ++k) motion_.update(flying, plotAt(4.0 * k, 50e3 + 800.0 * k, 1.0), quality());
  EXPECT_GT(flying.fixed.moving_evidence, 2.0);
}

TEST_F(TurningMotion, ATrackOverTheSiteStaysFinite) {
  fly(1e-3, -40.0, 40.0);
  const Kinematics k = motion_.at(track_, 0.0).kinematics;
  for (const double value : {k.range, k.azimuth, k.range_rate, k.azimuth_rate}) EXPECT_TRUE(std::isfinite(value));
  EXPECT_NEAR(track_.smoothed.x, 10e3, 50.0);
}

}  // namespace
}  // namespace adit_tracker
