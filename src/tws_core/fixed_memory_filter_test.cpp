#include <tws_core/fixed_memory_filter.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <tws_core/axis_filter_test_helpers.h>
#include <tws_core/random_test_helpers.h>

namespace tws {
namespace {

TEST(FixedMemory, IsTheMeanOfItsWindowForDegree0) {
  const FixedMemoryFilter filter(0, 3);
  FixedMemoryState state = filter.start(100.0, {});
  for (double measured : {1.0, 2.0, 6.0}) updateTo(filter, state, measured, 4.0, {});
  EXPECT_DOUBLE_EQ(state.motion.position, 3.0);  // 100 is forgotten, all others count alike
}

// Against the textbook's least squares, at uneven times.
TEST(FixedMemory, IsTheLeastSquaresPolynomialThroughItsWindowAtAnyTimes) {
  auto generator = seededGenerator();
  for (int degree = 0; degree <= 2; ++degree) {
    for (int length : {degree + 1, 5, 16}) {
      const FixedMemoryFilter filter(degree, length);
      std::vector<double> times{0.0}, values{5e4};
      FixedMemoryState state = filter.start(values[0], {});
      for (int k = 0; k < 30; ++k) {
        const double dt = uniform(generator, 0.5, 8.0);
        times.push_back(times.back() + dt);
        values.push_back(5e4 + uniform(generator, -500.0, 500.0));
        updateTo(filter, state, values.back(), dt, {});
        const int n = std::min<int>(length, static_cast<int>(values.size()));
        const int terms = std::min(degree + 1, n);
        Eigen::MatrixXd A(n, terms);
        Eigen::VectorXd y(n);
        for (int i = 0; i < n; ++i) {
          y[i] = values[values.size() - 1 - i];
          for (int j = 0; j < terms; ++j) A(i, j) = std::pow(times[times.size() - 1 - i] - times.back(), j);
        }
        const Eigen::VectorXd fit = A.colPivHouseholderQr().solve(y);
        ASSERT_NEAR(state.motion.position, fit[0], 1e-6);
        ASSERT_NEAR(state.motion.velocity, terms > 1 ? fit[1] : 0.0, 1e-6);
        ASSERT_NEAR(state.motion.acceleration, terms > 2 ? 2.0 * fit[2] : 0.0, 1e-6);
      }
    }
  }
}

// A flat window forgets at once: five scans after a turn nothing of the old course is left.
TEST(FixedMemory, ForgetsAllThatLeavesItsWindow) {
  const FixedMemoryFilter filter(1, 5);
  FixedMemoryState state = filter.start(0.0, {});
  for (int k = 1; k < 20; ++k) updateTo(filter, state, 1000.0 * k, 1.0, {});
  for (int k = 0; k < 5; ++k) updateTo(filter, state, 7.0 - 3.0 * k, 1.0, {});
  EXPECT_NEAR(state.motion.position, -5.0, 1e-9);
  EXPECT_NEAR(state.motion.velocity, -3.0, 1e-9);
}

TEST(FixedMemory, RefusesAWindowThatCannotHoldItsPolynomial) {
  EXPECT_THROW(FixedMemoryFilter(2, 2), std::invalid_argument);
  EXPECT_THROW(FixedMemoryFilter(1, 17), std::invalid_argument);
  EXPECT_THROW(FixedMemoryFilter(3, 8), std::invalid_argument);
}

}  // namespace
}  // namespace tws
