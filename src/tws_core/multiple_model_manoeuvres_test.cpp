// What the filter makes of turns, changes of speed, hard manoeuvres and plots that may be another's.
#include <tws_core/multiple_model_filter.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include <tws_core/dense_imm_test_helpers.h>

namespace tws {
namespace {

// If this fails, an aircraft that holds is lost at the first turn.
TEST(MultipleModelFilter, SeesThatATargetTurns) {
  const MultipleModelParams params = textbook();
  MultipleModelFilter filter;
  for (int k = 0; k < 30; ++k) {
    const double t = 4.0 * k, turned = k < 15 ? 0.0 : params.turn_rate * (t - 60.0);
    PlanarPosition z;
    z.x = k < 15 ? 200.0 * t : 12000.0 + 200.0 / params.turn_rate * std::sin(turned);
    z.y = k < 15 ? 0.0 : 200.0 / params.turn_rate * (1.0 - std::cos(turned));
    z.covariance = {10000.0, 0.0, 10000.0};
    if (k == 0) {
      filter.start(z, params);
    } else {
      filter.update(z, 4.0, params);
    }
    if (k == 14) {
      EXPECT_GT(filter.straightProbability(), 0.9);
    }
  }
  EXPECT_LT(filter.straightProbability(), 0.5);
}

/// Distance between where the filter expects a target that has turned for `scans` of 4 s, and where it is then [m].
double missAfterTurn(const MultipleModelParams& params, double turn_rate, int scans) {
  constexpr double kSpeed = 200.0;
  MultipleModelFilter filter;
  PlanarPosition z;
  z.covariance = {10000.0, 0.0, 10000.0};
  const auto place = [&](double t) {
    z.x = kSpeed / turn_rate * std::sin(turn_rate * t);
    z.y = 40e3 + kSpeed / turn_rate * (1.0 - std::cos(turn_rate * t));
  };
  place(0.0);
  filter.start(z, params);
  for (int k = 1; k <= scans; ++k) {
    place(4.0 * k);
    filter.update(z, 4.0, params);
  }
  place(4.0 * scans + 8.0);
  const PlanarPosition there = filter.predictPosition(8.0, params);
  return std::hypot(there.x - z.x, there.y - z.y);
}

// If this fails, an aircraft that turns faster or slower than most is shown beside its place, and lost after two
// misses.
TEST(MultipleModelFilter, LearnsHowFastATargetTurns) {
  MultipleModelParams learning = textbook(), fixed = textbook();
  fixed.turn_rate_sigma = 0.0;
  for (const double rate : {radians(1.2), radians(3.2), radians(-3.2)}) {
    EXPECT_LT(missAfterTurn(learning, rate, 10), 0.6 * missAfterTurn(fixed, rate, 10)) << degrees(rate) << " deg/s";
  }
}

/// Root mean square error of the filter's position over a flight that speeds up at 1 g for 20 s, without noise [m].
double errorWhileSpeedingUp(const MultipleModelParams& params) {
  MultipleModelFilter filter;
  double sum = 0.0;
  for (int k = 0; k <= 25; ++k) {
    const double t = 4.0 * k, faster = std::min(std::max(t - 60.0, 0.0), 20.0);
    PlanarPosition z;
    z.x = 150.0 * t + 0.5 * 9.81 * faster * faster + 9.81 * faster * (std::max(t - 60.0, 0.0) - faster);
    z.y = 40e3;
    z.covariance = {10000.0, 0.0, 40000.0};
    if (k == 0) {
      filter.start(z, params);
      continue;
    }
    filter.update(z, 4.0, params);
    if (k > 15) sum += std::pow(filter.mean().x - z.x, 2.0) / 10.0;
  }
  return std::sqrt(sum);
}

// If this fails, a fighter with its burner lit flies out of its track.
TEST(MultipleModelFilter, FollowsAChangeOfSpeed) {
  MultipleModelParams with = textbook(), without = textbook();
  without.free_share = 0.0;
  EXPECT_LT(errorWhileSpeedingUp(with), 0.6 * errorWhileSpeedingUp(without));
}

TEST(MultipleModelFilter, ChancesOfItsModelsAddUpToOne) {
  const MultipleModelParams params = textbook();
  const PlanarPosition z{700.0, 100.0, {10000.0, 0.0, 20000.0}};
  MultipleModelFilter filter;
  filter.start(z, params);
  for (int k = 0; k < 5; ++k) {
    const auto& p = filter.probabilities();
    EXPECT_NEAR(std::accumulate(p.begin(), p.end(), 0.0), 1.0, 1e-9) << k << " updates";
    filter.update({{z, 0.7}}, 0.3, 4.0, params);
  }
}

/// A track that has flown straight to the east over (0, 30 km) at 200 m/s.
MultipleModelFilter straightFlight(const MultipleModelParams& params) {
  MultipleModelFilter filter;
  PlanarPosition z;
  z.y = 30e3;
  z.covariance = {10000.0, 0.0, 10000.0};
  filter.start(z, params);
  for (int k = 1; k < 10; ++k) {
    z.x += 800.0;
    filter.update(z, 4.0, params);
  }
  return filter;
}

// If this fails, a fighter that breaks away loses its track.
TEST(MultipleModelFilter, FollowsAHardManoeuvreAtOnce) {
  MultipleModelParams params = textbook();
  PlanarPosition z;
  z.x = 8000.0;
  z.y = 30e3 + 2000.0;  // 250 m/s² for 4 s: no turning model comes near.
  z.covariance = {10000.0, 0.0, 10000.0};
  MultipleModelFilter without = straightFlight(params), with = without;
  const double unexplained = without.update(z, 4.0, params);
  params.manoeuvre_acceleration = 250.0;
  const double explained = with.update(z, 4.0, params);
  EXPECT_GT(explained, unexplained);
  EXPECT_NEAR(with.mean().y, z.y, 30.0);      // The plot is believed: its sigma is 100 m, that of the manoeuvre 2000 m.
  EXPECT_NEAR(with.mean().vy, 1000.0, 60.0);  // 2000 m = ½ a t², v = a t.
}

TEST(MultipleModelFilter, ManoeuvresChangeNothingWhileTheModelsExplainThePlots) {
  MultipleModelParams params = textbook();
  const Vector4 without = meanOf(straightFlight(params).mean());
  params.manoeuvre_acceleration = 10.0;
  EXPECT_EQ(meanOf(straightFlight(params).mean()), without);
}

// If this fails, a user who switches manoeuvres off still has their penalty: far plots weigh a hundredth.
TEST(MultipleModelFilter, WithoutManoeuvresAFarPlotHasTheTextbooksLikelihood) {
  DenseImm dense;
  PlanarPosition z;
  z.covariance = {10000.0, 0.0, 10000.0};
  MultipleModelFilter filter;
  filter.start(z, dense.params);
  dense.start(z);
  z.x = 6000.0;  // 150 m/s for 4 s is one standard deviation.
  EXPECT_NEAR(filter.update(z, 4.0, dense.params), dense.update(z, 4.0), 1e-6);
}

// Of one measurement that is surely the target's, or of none, the weighed update is what the plain one or time makes.
TEST(MultipleModelFilter, AWeighedUpdateInTheSureCasesIsThePlainOne) {
  const MultipleModelParams params = textbook();
  const PlanarPosition z{700.0, 100.0, {10000.0, 0.0, 20000.0}};
  MultipleModelFilter plain = straightFlight(params), weighed = plain, missed = plain;
  plain.update(z, 4.0, params);
  weighed.update({{z, 1.0}}, 0.0, 4.0, params);
  EXPECT_TRUE(meanOf(weighed.mean()).isApprox(meanOf(plain.mean()), 1e-9));
  EXPECT_NEAR(weighed.straightProbability(), plain.straightProbability(), 1e-9);
  const PlanarMotion before = missed.predict(4.0, params);
  missed.update({}, 1.0, 4.0, params);
  EXPECT_NEAR(missed.mean().x, before.x, 5.0);  // Models mix as time goes.
}

// Half of one measurement, half of none: the mean lies in the middle, and the spread of both is in the covariance.
TEST(MultipleModelFilter, AWeighedUpdateIsTheMixtureOfItsCases) {
  MultipleModelParams params = textbook();
  params.manoeuvre_acceleration = 0.0;
  const MultipleModelFilter start = straightFlight(params);
  PlanarPosition z = start.predictPosition(4.0, params);
  z.covariance = {10000.0, 0.0, 10000.0};
  PlanarPosition left = z, right = z;
  left.y += 300.0;
  right.y -= 300.0;
  MultipleModelFilter both = start, one = start;
  both.update({{left, 0.5}, {right, 0.5}}, 0.0, 4.0, params);
  one.update(z, 4.0, params);
  EXPECT_NEAR(both.mean().y, one.mean().y, 5.0);
  EXPECT_GT(both.predict(0.0, params).position.yy, one.predict(0.0, params).position.yy + 1000.0);
}

// If this fails, a fast aircraft's second plot is outside of its gate.
TEST(MultipleModelFilter, AFastSpeedSigmaWidensTheGateOfANewTrack) {
  MultipleModelParams params = textbook();
  PlanarPosition z;
  z.covariance = {10000.0, 0.0, 10000.0};
  MultipleModelFilter usual, wide;
  usual.start(z, params);
  params.fast_speed_sigma = 3.0 * params.speed_sigma;
  params.fast_share = 0.2;
  wide.start(z, params);
  EXPECT_GT(wide.predictPosition(6.0, params).covariance.xx, 2.0 * usual.predictPosition(6.0, params).covariance.xx);
}

// If this fails, aircraft at a height are lost when they pass near the site.
TEST(MultipleModelFilter, AFlightAtTheAssumedHeightStaysWithinItsGateNearTheSite) {
  MultipleModelParams params = textbook();
  params.assumed_height = 10e3;
  MultipleModelFilter filter;
  for (int k = 0; k <= 60; ++k) {
    const double t = 4.0 * k, x = -30e3 + 250.0 * t, y = 10e3;
    const double slant = std::sqrt(x * x + y * y + 1e8), azimuth = std::atan2(x, y);
    const PlanarPosition z = planarMeasurement(slant, azimuth, 100.0, 0.005);
    if (k == 0) {
      filter.start(z, params);
      continue;
    }
    const PlanarMotion p = filter.predict(4.0, params);
    const Symmetric2 s{p.position.xx + z.covariance.xx, p.position.xy + z.covariance.xy,
                       p.position.yy + z.covariance.yy};
    EXPECT_LT(s.mahalanobis(z.x - p.x, z.y - p.y), 25.0) << "at x " << x;
    filter.update(z, 4.0, params);
  }
}

}  // namespace
}  // namespace tws
