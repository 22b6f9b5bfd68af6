#include <tws_core/range_rate.h>

#include <gtest/gtest.h>

#include <tws_core/dense_imm_test_helpers.h>
#include <tws_core/random_test_helpers.h>

namespace tws {
namespace {

/// A target at 30 km to the east that flies north by east.
PlanarMotion eastern() {
  PlanarMotion s;
  s.x = 30e3;
  s.vx = 60.0;
  s.vy = 200.0;
  s.position = {1e4, 0.0, 2.25e4};
  s.velocity = {100.0, 0.0, 400.0};
  return s;
}

RangeRate measured(double value, double sigma) {
  RangeRate z;
  z.value = value;
  z.sigma = sigma;
  return z;
}

TEST(RangeRate, OfAMotionByHand) {
  const RangeRatePrediction p = predictRangeRate(eastern(), measured(0.0, 1.0));
  EXPECT_DOUBLE_EQ(p.value, 60.0);
  EXPECT_DOUBLE_EQ(p.vx, 1.0);
  EXPECT_DOUBLE_EQ(p.vy, 0.0);
  EXPECT_DOUBLE_EQ(p.x, 0.0);
  EXPECT_DOUBLE_EQ(p.y, 200.0 / 30e3);
  // 10 m/s along, 200 m/s · 150 m / 30 km of the direction, 20 m/s · 150 m / 30 km of both.
  EXPECT_NEAR(p.variance, 100.0 + 1.0 + 0.01, 1e-9);
}

// A radar that stands elsewhere, a target overhead of the plane: 30 km east and 40 km up, seen from 10 km to the west.
TEST(RangeRate, CountsFromTheRadarAlongTheSlant) {
  RangeRate radar = measured(0.0, 1.0);
  radar.x = 40e3 - 30e3;
  radar.squared_height = 40e3 * 40e3;
  PlanarMotion s = eastern();
  s.x = 40e3;
  EXPECT_DOUBLE_EQ(predictRangeRate(s, radar).value, 60.0 * 3.0 / 5.0);
}

// If it fails, the rate of a new track is trusted too much: neither its direction nor its speed across is known.
TEST(RangeRate, VarianceIsThatOfSimulatedTargets) {
  auto generator = seededGenerator();
  PlanarMotion s = eastern();
  s.vx = s.vy = 0.0;
  s.position = {1e4, 0.0, 1e6};
  s.velocity = {25.0, 0.0, 250.0 * 250.0};
  std::normal_distribution<double> normal;
  double squares = 0.0;
  constexpr int kTargets = 100000;
  for (int i = 0; i < kTargets; ++i) {
    Vector5 x;
    x << s.x + 100.0 * normal(generator), 1000.0 * normal(generator), 5.0 * normal(generator),
        250.0 * normal(generator), 0.0;
    squares += std::pow(rangeRate(x, measured(0.0, 1.0)), 2) / kTargets;
  }
  EXPECT_NEAR(predictRangeRate(s, measured(0.0, 1.0)).variance / squares, 1.0, 0.02);
}

/// Any state of a target with a turn rate, with any covariance.
TurningMotion randomMotion(std::mt19937_64& generator, Vector5& x, Matrix5& p) {
  Matrix5 root;
  for (int i = 0; i < 25; ++i) root(i / 5, i % 5) = uniform(generator, -1.0, 1.0);
  const Vector5 scale(200.0, 200.0, 20.0, 20.0, 0.01);
  root = scale.asDiagonal() * root;
  p = root * root.transpose();
  x << uniform(generator, -60e3, 60e3), uniform(generator, 10e3, 60e3), uniform(generator, -300.0, 300.0),
      uniform(generator, -300.0, 300.0), uniform(generator, -0.1, 0.1);
  TurningMotion s;
  s.x = x[0], s.y = x[1], s.vx = x[2], s.vy = x[3], s.rate = x[4];
  s.position = {p(0, 0), p(0, 1), p(1, 1)};
  s.x_vx = p(0, 2), s.x_vy = p(0, 3), s.y_vx = p(1, 2), s.y_vy = p(1, 3);
  s.velocity = {p(2, 2), p(2, 3), p(3, 3)};
  s.rate_variance = p(4, 4);
  s.x_rate = p(0, 4), s.y_rate = p(1, 4), s.vx_rate = p(2, 4), s.vy_rate = p(3, 4);
  return s;
}

// If it fails, range rates pull every track off.
TEST(RangeRate, CorrectsAsADenseExtendedKalmanFilterDoes) {
  auto generator = seededGenerator();
  for (int run = 0; run < 200; ++run) {
    Vector5 x;
    Matrix5 p;
    TurningMotion s = randomMotion(generator, x, p);
    RangeRate z = measured(0.0, uniform(generator, 0.5, 10.0));
    z.x = uniform(generator, -5e3, 5e3);
    z.squared_height = uniform(generator, 0.0, 1e8);
    z.squared_height_variance = uniform(generator, 0.0, 1e14);
    z.value = rangeRate(x, z) + uniform(generator, -30.0, 30.0);
    const MeasurementFit alone = fitOf(s, z), fit = correct(s, z);
    const double likelihood = correctDensely(x, p, z);
    EXPECT_NEAR(fit.density * std::exp(-0.5 * fit.squared_distance) / likelihood, 1.0, 1e-4);
    EXPECT_EQ(alone.squared_distance, fit.squared_distance);
    EXPECT_LT((meanOf(s) - x.head<4>()).norm(), 1e-3);
    EXPECT_NEAR(s.rate, x[4], 1e-7);
    EXPECT_LT((denseOf(s) - p.topLeftCorner<4, 4>()).norm(), 1e-5 * p.norm());
    EXPECT_NEAR(s.rate_variance, p(4, 4), 1e-5 * p(4, 4) + 1e-12);
    EXPECT_LT((Vector4(s.x_rate, s.y_rate, s.vx_rate, s.vy_rate) - p.col(4).head<4>()).norm(),
              1e-4 * p.col(4).norm() + 1e-9);
  }
}

// If it fails, a radar with an unambiguous velocity of 25 m/s throws aircraft off whenever their rates fold.
TEST(RangeRate, TakesTheNearestFold) {
  RangeRate z = measured(60.0 + 3.0 - 200.0, 2.0);
  z.ambiguity = 50.0;
  PlanarMotion s = eastern();
  s.velocity = {9.0, 0.0, 9.0};
  RangeRate whole = measured(63.0, 2.0);
  EXPECT_NEAR(fitOf(s, z).squared_distance, fitOf(s, whole).squared_distance, 1e-9);
}

TEST(RangeRate, IsOfNoUseWhereItsFoldCannotBeTold) {
  RangeRate z = measured(10.0, 2.0);
  z.ambiguity = 30.0;  // The rate is known to 10 m/s.
  TurningMotion s;
  static_cast<PlanarMotion&>(s) = eastern();
  const MeasurementFit fit = correct(s, z);
  EXPECT_EQ(fit.squared_distance, 0.0);
  EXPECT_DOUBLE_EQ(fit.density, 1.0 / 30.0);
  EXPECT_EQ(meanOf(s), meanOf(eastern()));
}

TEST(RangeRate, MeansNothingAtTheRadarItselfButBreaksNothing) {
  TurningMotion s;
  s.vx = 100.0;
  s.position = {1e4, 0.0, 1e4};
  s.velocity = {100.0, 0.0, 100.0};
  correct(s, measured(50.0, 1.0));
  for (const double value : {s.x, s.y, s.vx, s.vy, s.position.xx, s.velocity.xx}) EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace tws
