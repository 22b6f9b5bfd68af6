#include <tws_core/alpha_beta.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <stdexcept>
#include <string>
#include <vector>

#include <tws_core/random_test_helpers.h>

namespace tws {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
const std::vector<double> kDampings{0.1, 0.4, 0.7, 0.99};

TEST(Gains, HaveTheValuesWorkedOutFromEquations2And3) {
  EXPECT_NEAR(gains(1.0, 0.7).alpha, 0.7534030360583935, 1e-14);
  EXPECT_NEAR(gains(1.0, 0.7).beta, 0.496102697090847, 1e-14);
  EXPECT_NEAR(gains(0.3, 0.7).alpha, 0.34295318018494325, 1e-14);
  EXPECT_NEAR(gains(0.3, 0.7).beta, 0.07294205007447552, 1e-14);
  EXPECT_NEAR(gains(2.5, 0.4).alpha, 0.8646647167633873, 1e-14);
  EXPECT_NEAR(gains(2.5, 0.4).beta, 1.6207552374617906, 1e-14);
}

// What the equations are for: the filter's poles lie at exp(-ξω₀T ± jω_dT). With β·T instead of β/T they would not.
TEST(Gains, PutTheFiltersPolesWhereDampingAndBandwidthSay) {
  for (double damping : kDampings) {
    for (double x : {0.01, 0.2, 1.0, 3.0}) {
      const auto [alpha, beta] = gains(x, damping);
      const std::complex<double> pole =
          std::exp(std::complex<double>(-damping * x, x * std::sqrt(1 - damping * damping)));
      // Error of the steady filter: z² - (2 - α - β)·z + (1 - α) = 0.
      EXPECT_NEAR(std::abs(pole * pole - (2 - alpha - beta) * pole + (1 - alpha)), 0.0, 1e-14) << damping << ' ' << x;
    }
  }
}

TEST(Gains, KeepEveryFilterStable) {
  for (double damping : kDampings) {
    for (int i = 0; i < 100; ++i) {
      const double x = 0.001 * std::pow(1.1, i);  // 0.001 to 12.5
      const auto [alpha, beta] = gains(x, damping);
      EXPECT_GT(alpha, 0.0);
      EXPECT_GT(beta, 0.0);
      EXPECT_GT(4 - 2 * alpha - beta, 0.0);  // figure 3.5 of Henery 1985
    }
  }
}

TEST(Gains, VanishWithoutLossOfDigitsForSmallSteps) {
  const auto [alpha, beta] = gains(1e-9, 0.7);
  EXPECT_NEAR(alpha / 1.4e-9, 1.0, 1e-8);
  EXPECT_NEAR(beta / 1e-18, 1.0, 1e-8);
  EXPECT_EQ(gains(0.0, 0.7).alpha, 0.0);
  EXPECT_EQ(gains(0.0, 0.7).beta, 0.0);
}

TEST(GainTable, StaysWithinItsPromisedErrorEverywhere) {
  for (double damping : kDampings) {
    for (double step : {1.0 / 1024, 1.0 / 64, 0.1}) {
      const GainTable table(damping, step);
      for (int i = 0; i < 32000; ++i) {
        const double x = i * 0.00037;  // to 11.8, past the end
        const AlphaBetaGains looked_up = table.lookup(x), exact = gains(x, damping);
        ASSERT_LE(std::abs(looked_up.alpha - exact.alpha), damping * step * (1 + 1e-12)) << x;
        ASSERT_LE(std::abs(looked_up.beta - exact.beta), (1 + damping) * step * (1 + 1e-12)) << x;
      }
    }
  }
}

TEST(GainTable, AnswersBeyondItsEndLikeTheExactFunction) {
  const GainTable table(0.1, 0.01, 1.0);
  EXPECT_EQ(table.lookup(5.123).beta, gains(5.123, 0.1).beta);
  EXPECT_EQ(table.lookup(1e9).alpha, 1.0);
}

TEST(GainTable, RefusesWhatItCannotTabulate) {
  for (double damping : {0.0, 1.0, -0.5, kNaN}) EXPECT_THROW(GainTable{damping}, std::invalid_argument) << damping;
  EXPECT_THROW(GainTable(0.7, 0.0), std::invalid_argument);
  EXPECT_THROW(GainTable(0.7, 1e-3, 1e9), std::invalid_argument);
}

TEST(AdaptiveAlphaBetaParameters, AreRefusedWithTheNameOfTheWrongOne) {
  const auto refused = [](double AdaptiveAlphaBetaParams::*field, double value, const std::string& name) {
    AdaptiveAlphaBetaParams params;
    params.*field = value;
    try {
      AdaptiveAlphaBeta filter(params);
      ADD_FAILURE() << name << " = " << value << " was taken";
    } catch (const std::invalid_argument& error) {
      EXPECT_EQ(std::string(error.what()).rfind(name + " is ", 0), 0U) << error.what();
    }
  };
  for (double value : {0.0, 1.0, -1.0, kNaN}) refused(&AdaptiveAlphaBetaParams::damping, value, "damping");
  for (double value : {0.0, -1.0, kNaN, HUGE_VAL}) {
    refused(&AdaptiveAlphaBetaParams::omega_a, value, "omega_a");
    refused(&AdaptiveAlphaBetaParams::omega_b, value, "omega_b");
    refused(&AdaptiveAlphaBetaParams::omega_min, value, "omega_min");
  }
  for (double value : {0.01, kNaN, HUGE_VAL}) refused(&AdaptiveAlphaBetaParams::omega_max, value, "omega_max");
}

AdaptiveAlphaBetaParams wideOpen() { return {0.7, 0.1, 0.2, 0.001, 10.0}; }

TEST(AdaptiveAlphaBeta, TakesTheStepsOfEquations1To6AsWorkedOutByHand) {
  const AdaptiveAlphaBeta filter(wideOpen());
  AlphaBetaState state = filter.start(10.0, 1.0, 4.0);
  filter.update(state, 2.0, 5.0);
  EXPECT_EQ(state.p1, 4.0);  // the first error has no predecessor
  EXPECT_EQ(state.omega0, 0.5);
  const double position = state.position, velocity = state.velocity;
  filter.update(state, 3.0, 5.0);
  EXPECT_NEAR(state.p1, 4.0 * 0.6065306597126334 + 0.3934693402873666 * 6.0, 1e-12);   // (4), e^-0.5
  EXPECT_NEAR(state.p2, 4.0 * 0.36787944117144233 + 0.6321205588285577 * 9.0, 1e-12);  // (5), e^-1
  EXPECT_NEAR(state.omega0, 0.5 * 4.786938680574733 / 7.160602794142788, 1e-12);       // (6)
  const auto [alpha, beta] = gains(state.omega0 * 5.0, 0.7);
  EXPECT_NEAR(state.position, position + 5.0 * velocity + alpha * 3.0, 3.0 * 0.7 / 1024);  // (1a)
  EXPECT_NEAR(state.velocity, velocity + beta * 3.0 / 5.0, 3.0 / 5.0 * 1.7 / 1024);        // (1b)
}

TEST(AdaptiveAlphaBeta, StartsWithItsGreatestBandwidth) {
  AdaptiveAlphaBetaParams params = wideOpen();
  params.omega_max = 0.4;
  const AdaptiveAlphaBeta filter(params);
  AlphaBetaState state = filter.start(0.0);
  filter.update(state, 123.0, 4.0);
  EXPECT_EQ(state.omega0, 0.4);
}

double bandwidthAfter(const std::vector<double>& pattern) {
  AdaptiveAlphaBetaParams params{0.7, 0.05, 0.05, 0.02, 0.45};
  const AdaptiveAlphaBeta filter(params);
  AlphaBetaState state = filter.start(0.0, 0.0, 1.0);
  for (int i = 0; i < 200; ++i) filter.update(state, pattern[i % pattern.size()], 4.0);
  return state.omega0;
}

// Errors alike mean a manoeuvre: the band opens. Errors without relation mean noise: it closes.
TEST(AdaptiveAlphaBeta, OpensItsBandwidthForErrorsAlikeAndClosesItForUnrelatedOnes) {
  EXPECT_EQ(bandwidthAfter({1.0}), 0.45);        // eq. (6) gives 0.5, above omega_max
  EXPECT_EQ(bandwidthAfter({1.0, -1.0}), 0.45);  // as printed: |p₁/p₂| cannot tell the sign
  EXPECT_EQ(bandwidthAfter({1.0, 0.0}), 0.02);   // eq. (6) gives 0, below omega_min
}

TEST(AdaptiveAlphaBeta, TakesErrorsOfZeroWithoutDividingByZero) {
  const AdaptiveAlphaBeta filter(wideOpen());
  AlphaBetaState state = filter.start(5.0, 2.0);
  for (int i = 0; i < 10; ++i) filter.update(state, 0.0, 1.0);
  EXPECT_EQ(state.position, 25.0);
  EXPECT_EQ(state.velocity, 2.0);
  EXPECT_EQ(state.omega0, 10.0);
}

// Two radars that cross a target in the same instant must not throw its velocity away.
TEST(AdaptiveAlphaBeta, ChangesTheVelocityEverLessAsTheTimeBetweenUpdatesVanishes) {
  const AdaptiveAlphaBeta filter({0.7, 0.05, 0.05, 0.05, 0.5});
  for (int i = 0; i < 24; ++i) {
    const double T1 = 0.1 * std::pow(3.0, -i);
    AlphaBetaState state = filter.start(1000.0, 200.0);
    filter.update(state, 100.0, T1);
    EXPECT_LE(std::abs(state.velocity - 200.0), 4 * 0.5 * 0.5 * T1 * 100.0 + 1e-12)
        << T1;  // β ≤ (ω₀T₁)², quantised at most 4 times
  }
  AlphaBetaState state = filter.start(1000.0, 200.0);
  filter.update(state, 100.0, 0.0);
  EXPECT_EQ(state.position, 1000.0);
  EXPECT_EQ(state.velocity, 200.0);
}

TEST(AdaptiveAlphaBeta, SettlesOnATargetOfConstantVelocitySeenAtUnevenTimes) {
  auto generator = seededGenerator();
  const AdaptiveAlphaBeta filter({0.7, 0.05, 0.05, 0.1, 0.5});
  AlphaBetaState state = filter.start(20000.0);
  double truth = 20000.0;
  for (int i = 0; i < 200; ++i) {
    const double T1 = uniform(generator, 0.1, 8.0);
    truth -= 150.0 * T1;
    filter.update(state, truth - AdaptiveAlphaBeta::predict(state, T1), T1);
  }
  EXPECT_NEAR(state.position, truth, 1e-6);
  EXPECT_NEAR(state.velocity, -150.0, 1e-6);
}

TEST(AdaptiveAlphaBeta, PredictsForwardsAndBackwards) {
  const AlphaBetaState state = AdaptiveAlphaBeta(wideOpen()).start(100.0, -3.0);
  EXPECT_EQ(AdaptiveAlphaBeta::predict(state, 4.0), 88.0);
  EXPECT_EQ(AdaptiveAlphaBeta::predict(state, -4.0), 112.0);
}

// One bad measurement may not turn a track into NaN for good.
TEST(AdaptiveAlphaBeta, RefusesBadInputAndKeepsTheTrack) {
  const AdaptiveAlphaBeta filter(wideOpen());
  AlphaBetaState state = filter.start(1.0, 2.0, 3.0);
  EXPECT_THROW(filter.update(state, 1.0, -0.001), std::invalid_argument);
  EXPECT_THROW(filter.update(state, 1.0, kNaN), std::invalid_argument);
  EXPECT_THROW(filter.update(state, kNaN, 1.0), std::invalid_argument);
  EXPECT_EQ(state.position, 1.0);
  EXPECT_EQ(state.velocity, 2.0);
  EXPECT_EQ(state.p2, 3.0);
  EXPECT_TRUE(std::isnan(state.last_error));
}

}  // namespace
}  // namespace tws
