#include "range_filter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace range_gate_tracker {
namespace {

RangeGateParams params() {
  RangeGateParams params;
  params.damping_time = 0.5;
  params.velocity_limit = 1e4;
  return params;
}

// Whoever chooses tau must know what it costs: the filter lags by v·Δt·α/(1-α), the sum of eq. (9).
TEST(DampedRange, LagsAMovingTargetByVelocityTimesTheMeanAgeOfItsData) {
  for (const double dt : {0.01, 0.02, 0.05}) {
    DampedRange filter(params());
    filter.start(10000.0);
    const double v = 150.0;
    double range = 10000.0;
    for (double time = 0.0; time < 20.0 * 0.5; time += dt) filter.update(range += v * dt, dt);
    const double alpha = std::exp(-dt / 0.5);
    EXPECT_NEAR(range - filter.range(), v * dt * alpha / (1.0 - alpha), 1e-4) << dt;
    EXPECT_NEAR(filter.rate(), v, 1e-4);
  }
}

// Eq. (9): (1-α) Σ αᵗ R(t-τ), written out for four measurements, the first of which stands for all before it.
TEST(DampedRange, IsTheExponentiallyWeightedMean) {
  DampedRange filter(params());
  filter.start(100.0);
  for (const double measured : {110.0, 90.0, 130.0}) filter.update(measured, 0.1);
  const double a = std::exp(-0.1 / 0.5);
  EXPECT_NEAR(filter.range(), (1 - a) * (130.0 + a * 90.0 + a * a * 110.0) + a * a * a * 100.0, 1e-9);
}

TEST(DampedRange, ForgetsByTimeNotByTheNumberOfProfiles) {
  DampedRange fine(params()), coarse(params());
  fine.start(0.0);
  coarse.start(0.0);
  for (int i = 0; i < 10; ++i) fine.update(100.0, 0.02);
  coarse.update(100.0, 0.2);
  EXPECT_NEAR(fine.range(), coarse.range(), 1e-9);
}

// One stray measurement must not take the gate off a target that cannot be so fast.
TEST(DampedRange, NeverMovesFasterThanTheVelocityLimit) {
  RangeGateParams limited = params();
  limited.velocity_limit = 200.0;
  DampedRange filter(limited);
  filter.start(5000.0);
  filter.update(9000.0, 0.02);
  EXPECT_DOUBLE_EQ(filter.range(), 5004.0);
  EXPECT_DOUBLE_EQ(filter.rate(), 200.0);
  filter.update(0.0, 0.02);
  EXPECT_DOUBLE_EQ(filter.range(), 5000.0);
}

TEST(DampedRange, ReusesThePreviousRangeWithoutAMeasurement) {
  DampedRange reused(params()), given(params());
  for (DampedRange* filter : {&reused, &given}) {
    filter->start(100.0);
    filter->update(120.0, 0.1);
  }
  reused.coast(0.1);
  given.update(120.0, 0.1);
  EXPECT_EQ(reused.range(), given.range());
}

TEST(DampedRange, PredictsByTheDampedRangeItself) {
  DampedRange filter(params());
  filter.start(100.0);
  filter.update(120.0, 0.1);
  EXPECT_EQ(filter.predicted(0.1), filter.range());
}

// The reason to choose it: it neither lags nor falls behind over long prediction times.
TEST(KalmanRange, PredictsATargetOfConstantVelocityWithoutLag) {
  KalmanRange filter(params());
  filter.start(10000.0);
  double range = 10000.0;
  for (int i = 0; i < 1000; ++i) filter.update(range += 150.0 * 0.02, 0.02);
  EXPECT_NEAR(filter.range(), range, 0.1);
  EXPECT_NEAR(filter.rate(), 150.0, 0.1);
  EXPECT_NEAR(filter.predicted(2.0), range + 300.0, 0.5);
  for (int i = 0; i < 50; ++i) filter.coast(0.02);
  EXPECT_NEAR(filter.range(), range + 150.0, 0.5);
}

TEST(KalmanRange, KeepsItsRateWithinTheVelocityLimit) {
  RangeGateParams limited = params();
  limited.velocity_limit = 3.0;
  KalmanRange filter(limited);
  filter.start(1000.0);
  filter.update(2000.0, 0.02);
  EXPECT_LE(filter.rate(), 3.0);
}

}  // namespace
}  // namespace range_gate_tracker
