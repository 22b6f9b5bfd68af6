#include <tws_core/axis_filter.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <tws_core/axis_filter_test_helpers.h>

namespace tws {
namespace {

const AxisNoise kNoise{50.0, 5.0, 200.0};

AxisFilterParams kind(const std::string& name) {
  AxisFilterParams params;
  params.kind = name;
  return params;
}

// What an operator chooses by its name must be that filter.
TEST(AxisFilter, GivesWhatTheChosenFilterGives) {
  const AxisFilter chosen(kind("kalman_ca"));
  const AxisKalman<3> direct;
  AxisFilter::State state = chosen.start(1000.0, kNoise);
  AxisKalmanState<3> expected = direct.start(1000.0, kNoise);
  for (double measured : {1200.0, 1450.0, 1580.0, 1900.0}) {
    updateTo(chosen, state, measured, 4.0, kNoise);
    updateTo(direct, expected, measured, 4.0, kNoise);
  }
  EXPECT_EQ(AxisFilter::motion(state).position, expected.mean[0]);
  EXPECT_EQ(AxisFilter::motion(state).acceleration, expected.mean[2]);
}

TEST(AxisFilter, FollowsAStandingTargetWithEveryKind) {
  for (const std::string& name : axisFilterKinds()) {
    const AxisFilter filter(kind(name));
    AxisFilter::State state = filter.start(5000.0, kNoise);
    for (int k = 0; k < 20; ++k) updateTo(filter, state, 5000.0, 6.0, kNoise);
    EXPECT_NEAR(AxisFilter::motion(state).position, 5000.0, 1e-6) << name;
    EXPECT_NEAR(AxisFilter::motion(state).velocity, 0.0, 1e-6) << name;
  }
}

// The α filter and degree 0 alone cannot follow a moving target (Henery 1985, section 3.3.1).
TEST(AxisFilter, FollowsConstantVelocityWithEveryKindButAlpha) {
  for (const std::string& name : axisFilterKinds()) {
    const AxisFilter filter(kind(name));
    AxisFilter::State state = filter.start(0.0, kNoise);
    for (int k = 1; k <= 300; ++k) updateTo(filter, state, 150.0 * 6.0 * k, 6.0, kNoise);
    const double lag = 150.0 * 6.0 * 300 - AxisFilter::motion(state).position;
    if (name == "alpha" || name == "alpha_index")
      EXPECT_GT(lag, 50.0) << name;
    else
      EXPECT_NEAR(lag, 0.0, 0.01) << name;
  }
}

// One bad measurement may not turn a track into NaN for good.
TEST(AxisFilter, RefusesBadInputAndKeepsTheTrackWithEveryKind) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  for (const std::string& name : axisFilterKinds()) {
    const AxisFilter filter(kind(name));
    AxisFilter::State state = filter.start(7.0, kNoise);
    updateTo(filter, state, 9.0, 2.0, kNoise);
    const AxisMotion before = AxisFilter::motion(state);
    EXPECT_THROW(filter.update(state, 1.0, -0.001, kNoise), std::invalid_argument) << name;
    EXPECT_THROW(filter.update(state, 1.0, kNaN, kNoise), std::invalid_argument) << name;
    EXPECT_THROW(filter.update(state, kNaN, 1.0, kNoise), std::invalid_argument) << name;
    filter.update(state, 1.0, 0.0, kNoise);  // no time, no news
    const AxisMotion after = AxisFilter::motion(state);
    EXPECT_EQ(after.position, before.position) << name;
    EXPECT_EQ(after.velocity, before.velocity) << name;
  }
}

TEST(AxisFilter, RefusesWhatIsNoFilter) {
  EXPECT_THROW(AxisFilter(kind("beta")), std::invalid_argument);
  AxisFilterParams params = kind("alpha_beta");
  params.beta = 0.0;
  EXPECT_THROW(AxisFilter{params}, std::invalid_argument);
  params = kind("alpha_beta_gamma");
  params.gamma = 3.0;
  EXPECT_THROW(AxisFilter{params}, std::invalid_argument);
  params = kind("fixed_memory");
  params.length = 1;
  EXPECT_THROW(AxisFilter{params}, std::invalid_argument);
}

TEST(AxisFilterKinds, HoldTheFiveFiltersAndThreeMemoriesOfTheThesis) {
  const auto& kinds = axisFilterKinds();
  for (const char* name : {"alpha", "alpha_beta", "adaptive_alpha_beta", "alpha_beta_gamma", "kalman_cv", "kalman_ca",
                           "fixed_memory", "expanding_memory", "fading_memory"})
    EXPECT_EQ(std::count(kinds.begin(), kinds.end(), name), 1) << name;
}

}  // namespace
}  // namespace tws
