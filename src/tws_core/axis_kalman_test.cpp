#include <tws_core/axis_kalman.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include <tws_core/axis_filter_test_helpers.h>
#include <tws_core/filter_gains.h>
#include <tws_core/random_test_helpers.h>

namespace tws {
namespace {

/// What an innovation of 1 adds to position, velocity and acceleration.
template <int N>
FilterGains gainsAfter(int updates, const AxisNoise& noise, double T) {
  const AxisKalman<N> filter;
  AxisKalmanState<N> state = filter.start(0.0, noise);
  for (int k = 0; k < updates; ++k) filter.update(state, 0.0, T, noise);  // stays at 0
  filter.update(state, 1.0, T, noise);
  const AxisMotion gained = AxisKalman<N>::motion(state);
  return {gained.position, gained.velocity * T, gained.acceleration * T * T};
}

// Two ways to the same gains: stepping the covariance, and Kalata's closed form.
TEST(AxisKalman, SettlesAtTheGainsOfTheTrackingIndex) {
  constexpr double T = 4.0;
  for (double index : {0.01, 0.3, 5.0}) {
    const AxisNoise noise{50.0, index * 50.0 / (T * T), 300.0};
    const FilterGains cv = gainsAfter<2>(3000, noise, T), ca = gainsAfter<3>(3000, noise, T);
    EXPECT_NEAR(cv.alpha, steadyGains(1, index).alpha, 1e-9) << index;
    EXPECT_NEAR(cv.beta, steadyGains(1, index).beta, 1e-9) << index;
    EXPECT_NEAR(ca.alpha, steadyGains(2, index).alpha, 1e-9) << index;
    EXPECT_NEAR(ca.beta, steadyGains(2, index).beta, 1e-9) << index;
    EXPECT_NEAR(ca.gamma, steadyGains(2, index).gamma, 1e-9) << index;
  }
}

// Nothing known of the velocity, no manoeuvres: the Kalman filter is the expanding memory of degree 1.
TEST(AxisKalman, IsAnExpandingMemoryForATargetThatNeverManoeuvres) {
  const AxisNoise noise{1.0, 1e-12, 1e6};
  for (int n = 2; n < 30; ++n) {
    const FilterGains gains = gainsAfter<2>(n - 2, noise, 2.0);
    EXPECT_NEAR(gains.alpha, expandingGains(1, n).alpha, 1e-6) << n;
    EXPECT_NEAR(gains.beta, expandingGains(1, n).beta, 1e-6) << n;
  }
}

// The tracking windows are sized by what the filter believes; a covariance that is wrong loses targets.
TEST(AxisKalman, IsConsistentOnTheMotionItAssumes) {
  auto generator = seededGenerator();
  std::normal_distribution<double> normal;
  const AxisNoise noise{60.0, 4.0, 150.0};
  const AxisKalman<2> filter;
  constexpr double T = 5.0;
  constexpr int kRuns = 400, kSteps = 50;
  double sum = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    double x = 0.0, v = 150.0 * normal(generator);
    AxisKalmanState<2> state = filter.start(60.0 * normal(generator), noise);
    for (int k = 0; k < kSteps; ++k) {
      const double a = 4.0 * normal(generator);
      x += v * T + 0.5 * a * T * T;
      v += a * T;
      updateTo(filter, state, x + 60.0 * normal(generator), T, noise);
    }
    const Eigen::Vector2d error(state.mean[0] - x, state.mean[1] - v);
    sum += error.dot(state.covariance.inverse() * error);
  }
  EXPECT_NEAR(sum, 2.0 * kRuns, 5.0 * 2.0 * std::sqrt(kRuns));  // χ² with 2 degrees of freedom each; five deviations
}

TEST(AxisKalman, StaysPositiveDefiniteWithFarMorePreciseMeasurements) {
  const AxisNoise noise{0.01, 10.0, 1e3};  // a centimetre
  const AxisKalman<3> filter;
  AxisKalmanState<3> state = filter.start(0.0, noise);
  for (int k = 0; k < 200; ++k) {
    filter.update(state, 1.0, 3.0, noise);
    ASSERT_EQ(Eigen::LLT<Eigen::Matrix3d>(state.covariance).info(), Eigen::Success) << k;
  }
}

}  // namespace
}  // namespace tws
