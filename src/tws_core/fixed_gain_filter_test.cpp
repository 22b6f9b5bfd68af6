#include <tws_core/fixed_gain_filter.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include <tws_core/axis_filter_test_helpers.h>
#include <tws_core/random_test_helpers.h>

namespace tws {
namespace {

constexpr double T = 6.0;

/// Distance of a settled filter behind a target with this position of time, at the last of many measurements.
template <class Truth>
double settledLag(const FixedGainFilter& filter, Truth truth, int steps = 2000) {
  FixedGainState state = filter.start(truth(0.0), {});
  for (int k = 1; k <= steps; ++k) updateTo(filter, state, truth(k * T), T, {});
  return truth(steps * T) - state.position;
}

// If this fails the operator's symbol trails its target by another distance than the books say.
TEST(AlphaFilter, LagsBehindConstantVelocityByEquation37) {
  for (double alpha : {0.2, 0.5, 0.8}) {
    const auto filter = FixedGainFilter::withGains({alpha, 0.0, 0.0});
    const double lag = settledLag(filter, [](double t) { return 250.0 * t; });
    EXPECT_NEAR(lag, 250.0 * T * (1.0 - alpha) / alpha, 1e-4);
  }
}

TEST(AlphaBetaFilter, LagsBehindConstantAccelerationAndNotBehindConstantVelocity) {
  const FilterGains gains{0.5, 0.2, 0.0};
  const auto filter = FixedGainFilter::withGains(gains);
  EXPECT_NEAR(settledLag(filter, [](double t) { return 1e5 - 250.0 * t; }), 0.0, 1e-6);
  EXPECT_NEAR(settledLag(
                  filter, [](double t) { return 1.5 * t * t; }, 500),
              3.0 * T * T * 0.5 / 0.2, 1e-3);
}

TEST(AlphaBetaGammaFilter, LagsBehindConstantJerkAndNotBehindConstantAcceleration) {
  const auto filter = FixedGainFilter::withGains({0.7, 0.4, 0.12});
  EXPECT_NEAR(settledLag(
                  filter, [](double t) { return 1.5 * t * t; }, 500),
              0.0, 1e-3);
  EXPECT_NEAR(settledLag(
                  filter, [](double t) { return 0.01 * t * t * t; }, 200),
              0.06 * T * T * T * 0.3 / 0.12, 1e-2);
}

// Expanding memory of degree d finds polynomials of that degree from their first d + 1 measurements on.
TEST(ExpandingMemory, FollowsAPolynomialOfItsDegreeFromTheStart) {
  const auto truth = [](int degree, double t) {
    return 1000.0 + (degree > 0 ? -90.0 * t : 0.0) + (degree > 1 ? 2.0 * t * t : 0.0);
  };
  for (int degree = 0; degree <= 2; ++degree) {
    const auto filter = FixedGainFilter::expandingMemory(degree);
    FixedGainState state = filter.start(truth(degree, 0.0), {});
    for (int k = 1; k < 50; ++k) {
      updateTo(filter, state, truth(degree, k * T), T, {});
      if (k < degree) continue;
      ASSERT_NEAR(state.position, truth(degree, k * T), 1e-6) << degree << ' ' << k;
    }
  }
}

TEST(ExpandingMemory, IsTheMeanOfAllMeasurementsForDegree0) {
  const auto filter = FixedGainFilter::expandingMemory(0);
  FixedGainState state = filter.start(3.0, {});
  for (double measured : {5.0, 10.0, -2.0}) updateTo(filter, state, measured, T, {});
  EXPECT_DOUBLE_EQ(state.position, 4.0);
}

// Degree 1, acceleration a: the end of the line lies a·T²(n-1)(n-2)/12 behind; twice the memory, four times the lag.
TEST(ExpandingMemory, LagsEverFurtherBehindATargetThatItsPolynomialCannotFollow) {
  const auto filter = FixedGainFilter::expandingMemory(1);
  FixedGainState state = filter.start(0.0, {});
  for (int n = 2; n <= 30; ++n) {
    const double time = (n - 1) * T;
    updateTo(filter, state, 0.5 * time * time, T, {});
    EXPECT_NEAR(0.5 * time * time - state.position, T * T * (n - 1) * (n - 2) / 12.0, 1e-6) << n;
  }
}

// Three polynomials by weighted least squares, the weights falling by θ an interval, against the recursion.
TEST(FadingMemory, SettlesAtTheLeastSquaresLineOfExponentiallyFadingData) {
  auto generator = seededGenerator();
  constexpr double kTheta = 0.6;
  const auto filter = FixedGainFilter::fadingMemory(1, kTheta);
  std::vector<double> measured;
  for (int k = 0; k < 200; ++k) measured.push_back(uniform(generator, -100.0, 100.0));
  FixedGainState state = filter.start(measured[0], {});
  for (std::size_t k = 1; k < measured.size(); ++k) updateTo(filter, state, measured[k], 1.0, {});
  double w = 0, wt = 0, wtt = 0, wy = 0, wty = 0;
  for (int age = 0; age < 200; ++age) {
    const double weight = std::pow(kTheta, age), y = measured[199 - age];
    w += weight, wt -= weight * age, wtt += weight * age * age, wy += weight * y, wty -= weight * age * y;
  }
  const double slope = (w * wty - wt * wy) / (w * wtt - wt * wt);
  EXPECT_NEAR(state.velocity, slope, 1e-9);
  EXPECT_NEAR(state.position, (wy - slope * wt) / w, 1e-9);
}

TEST(FilterByTrackingIndex, TakesItsGainsFromNoiseAndInterval) {
  const auto filter = FixedGainFilter::byTrackingIndex(1);
  const AxisNoise noise{100.0, 1.0, 200.0};
  for (double dt : {1.0, 8.0}) {
    const FilterGains expected = steadyGains(1, 1.0 * dt * dt / 100.0);
    EXPECT_EQ(filter.gainsAt(1000, dt, noise).alpha, expected.alpha);
    EXPECT_EQ(filter.gainsAt(1000, dt, noise).beta, expected.beta);
  }
}

TEST(FixedGainFilter, StartsByExpandingMemoryUntilItsOwnGainsAreGreater) {
  const auto filter = FixedGainFilter::withGains({0.4, 0.1, 0.0});
  EXPECT_EQ(filter.gainsAt(2, T, {}).beta, 1.0);
  EXPECT_DOUBLE_EQ(filter.gainsAt(3, T, {}).alpha, 5.0 / 6.0);
  EXPECT_EQ(filter.gainsAt(50, T, {}).alpha, 0.4);
  // Greater gains than those of the start are used as soon as the velocity is known.
  EXPECT_EQ(FixedGainFilter::withGains({1.2, 0.9, 0.0}).gainsAt(3, T, {}).alpha, 1.2);
}

TEST(FixedGainFilter, ReducesWhiteNoiseAsTheFormulaSays) {
  auto generator = seededGenerator();
  std::normal_distribution<double> normal(0.0, 100.0);
  const FilterGains gains{0.5, 0.2, 0.0};
  const auto filter = FixedGainFilter::withGains(gains);
  FixedGainState state = filter.start(0.0, {});
  double position = 0.0, velocity = 0.0;
  constexpr int kCount = 400000;
  for (int k = 0; k < kCount; ++k) {
    updateTo(filter, state, normal(generator), T, {});
    position += state.position * state.position / kCount;
    velocity += state.velocity * state.velocity / kCount;
  }
  // Errors of neighbours are correlated over some ten steps: √(2·10/400 000) = 0.7 %; five of them.
  EXPECT_NEAR(position / 1e4, noiseReduction(gains, T).position, 0.035 * noiseReduction(gains, T).position);
  EXPECT_NEAR(velocity / 1e4, noiseReduction(gains, T).velocity, 0.035 * noiseReduction(gains, T).velocity);
}

TEST(FixedGainFilter, RefusesConstantsThatAreNoFilter) {
  EXPECT_THROW(FixedGainFilter::withGains({0.0, 0.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(FixedGainFilter::withGains({1.0, 2.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(FixedGainFilter::withGains({0.5, 0.1, 0.5}), std::invalid_argument);
  EXPECT_THROW(FixedGainFilter::withGains({std::nan(""), 0.1, 0.0}), std::invalid_argument);
  EXPECT_THROW(FixedGainFilter::byTrackingIndex(3), std::invalid_argument);
  EXPECT_THROW(FixedGainFilter::fadingMemory(1, 1.0), std::invalid_argument);
  EXPECT_THROW(FixedGainFilter::expandingMemory(-1), std::invalid_argument);
}

}  // namespace
}  // namespace tws
