#include <tws_core/multiple_model_filter.h>

#include <gtest/gtest.h>

#include <tws_core/random_test_helpers.h>

#include <tws_core/dense_imm_test_helpers.h>

namespace tws {
namespace {

PlanarPosition randomMeasurement(std::mt19937_64& generator, double x, double y) {
  const double a = uniform(generator, 50.0, 500.0), b = uniform(generator, 50.0, 500.0);
  PlanarPosition z;
  z.covariance = {a * a, uniform(generator, -0.8, 0.8) * a * b, b * b};
  std::normal_distribution<double> normal;
  const double u = normal(generator), v = normal(generator);
  const Eigen::Vector2d error = denseOf(z.covariance).llt().matrixL() * Eigen::Vector2d(u, v);
  z.x = x + error[0];
  z.y = y + error[1];
  return z;
}

void expectNear(const Matrix4& a, const Matrix4& b, double relative) {
  EXPECT_LT((a - b).norm(), relative * a.norm()) << a << "\n\n" << b;
}

/// Flies the filter beside the textbook's and compares all that they tell.
void compareWithDense(DenseImm dense, std::mt19937_64& generator) {
  MultipleModelFilter filter;
  double x = 40e3, y = -30e3;
  const PlanarPosition first = randomMeasurement(generator, x, y);
  filter.start(first, dense.params);
  dense.start(first);
  for (int k = 0; k < 20; ++k) {
    const double dt = uniform(generator, 0.0, 8.0);
    x += 150.0 * dt;
    y -= 80.0 * dt;
    const PlanarPosition z = randomMeasurement(generator, x, y);
    const double log_likelihood = filter.update(z, dt, dense.params);
    ASSERT_NEAR(log_likelihood, dense.update(z, dt), 1e-5);
    for (std::size_t i = 0; i < filter.probabilities().size(); ++i)
      ASSERT_NEAR(filter.probabilities()[i], dense.mu[i], 1e-5);
    ASSERT_LT((meanOf(filter.mean()) - dense.mean()).norm(), 1e-3);
    expectNear(dense.covariance(), denseOf(filter.predict(0.0, dense.params)), 1e-5);
  }
  DenseImm later = dense;
  for (int i = 0; i < DenseImm::kModels; ++i) later.move(i, 7.0);
  const PlanarMotion predicted = filter.predict(7.0, dense.params);
  const PlanarPosition alone = filter.predictPosition(7.0, dense.params);
  EXPECT_NEAR(alone.x, predicted.x, 1e-6);
  EXPECT_NEAR(alone.y, predicted.y, 1e-6);
  EXPECT_LT((denseOf(alone.covariance) - denseOf(predicted.position)).norm(),
            1e-9 * denseOf(predicted.position).norm());
  EXPECT_LT((meanOf(predicted) - later.mean()).norm(), 1e-3);
  expectNear(later.covariance(), denseOf(predicted), 1e-5);
}

// If this fails, every track of the set `default` is wrong: position, speed, gate, chance of existence.
TEST(MultipleModelFilter, DoesWhatTheTextbookDoesWithDenseMatrices) {
  auto generator = seededGenerator();
  for (int run = 0; run < 50; ++run) {
    DenseImm dense;
    if (run % 2 == 1) dense.params = fixedRates();
    dense.params.turn_rate = uniform(generator, 0.02, 0.2);
    if (run % 2 == 0) dense.params.turn_rate_sigma = uniform(generator, 0.1, 0.5) * dense.params.turn_rate;
    dense.params.turning_time = uniform(generator, 5.0, 100.0);
    compareWithDense(dense, generator);
  }
}

// If this fails, tracks of radars that measure Doppler are wrong: position, speed, gate, chance of existence.
TEST(MultipleModelFilter, DoesWhatTheTextbookDoesWithRangeRates) {
  auto generator = seededGenerator();
  std::normal_distribution<double> normal;
  for (int run = 0; run < 20; ++run) {
    DenseImm dense;
    dense.params.turn_rate = uniform(generator, 0.02, 0.1);
    dense.params.turn_rate_sigma = 0.3 * dense.params.turn_rate;
    MultipleModelFilter filter;
    double x = 40e3, y = -30e3;
    PlanarPosition z = randomMeasurement(generator, x, y);
    filter.start(z, dense.params);
    dense.start(z);
    for (int k = 0; k < 20; ++k) {
      const double dt = uniform(generator, 1.0, 8.0);
      x += 150.0 * dt;
      y -= 80.0 * dt;
      z = randomMeasurement(generator, x, y);
      RangeRate rate;
      rate.sigma = 3.0;
      rate.x = 5e3;
      if (k % 4 != 0) {
        const double u = normal(generator);
        rate.value = ((x - rate.x) * 150.0 - y * 80.0) / std::hypot(x - rate.x, y) + rate.sigma * u;
      }
      ASSERT_NEAR(filter.update(z, rate, dt, dense.params), dense.update(z, rate, dt), 1e-4);
      for (std::size_t i = 0; i < filter.probabilities().size(); ++i)
        ASSERT_NEAR(filter.probabilities()[i], dense.mu[i], 1e-4);
      ASSERT_LT((meanOf(filter.mean()) - dense.mean()).norm(), 0.05);
      expectNear(dense.covariance(), denseOf(filter.predict(0.0, dense.params)), 1e-4);
    }
  }
}

TEST(MultipleModelFilter, ARateThatIsNotKnownChangesNoBit) {
  auto generator = seededGenerator();
  const MultipleModelParams params;
  PlanarPosition z = randomMeasurement(generator, 40e3, 20e3);
  MultipleModelFilter plain;
  plain.start(z, params);
  MultipleModelFilter with = plain;
  for (int k = 1; k < 10; ++k) {
    z = randomMeasurement(generator, 40e3 + 600.0 * k, 20e3);
    EXPECT_EQ(plain.update(z, 4.0, params), with.update(z, RangeRate{}, 4.0, params));
    plain.update({{z, 0.7}}, 0.3, 4.0, params);
    with.update({{z, 0.7, RangeRate{}}}, 0.3, 4.0, params);
    EXPECT_EQ(meanOf(plain.mean()), meanOf(with.mean()));
  }
}

// A new track knows how fast its target comes, and no more than before of how fast it goes across.
TEST(MultipleModelFilter, StartsWithTheRangeRateOfTheFirstPlot) {
  const MultipleModelParams params = textbook();
  const PlanarPosition z{0.0, 50e3, {250.0 * 250.0, 0.0, 100.0 * 100.0}};
  MultipleModelFilter filter;
  filter.start(z, params);
  RangeRate rate;
  rate.value = -180.0;
  rate.sigma = 2.0;
  const double log_likelihood = filter.correctBy(rate);
  const PlanarMotion now = filter.predict(0.0, params);
  EXPECT_NEAR(now.vy, -180.0, 0.5);
  EXPECT_NEAR(now.velocity.yy, 4.0, 1.0);  // 150 m/s across at 250 m / 50 km add 0.6 m²/s².
  EXPECT_NEAR(now.vx, 0.0, 1e-9);
  EXPECT_NEAR(now.velocity.xx, 150.0 * 150.0, 1.0);
  EXPECT_NEAR(log_likelihood, -0.5 * 1.44 - std::log(150.0 * std::sqrt(kTwoPi)), 0.01);
}

// If this fails, a fighter that breaks away between two scans loses its track, as its rate is out of all reason.
TEST(MultipleModelFilter, ARangeRateShowsAHardManoeuvre) {
  MultipleModelParams params;
  params.assumed_height = 0.0;
  MultipleModelFilter filter;
  PlanarPosition z{40e3, 0.0, {1e4, 0.0, 4e4}};
  filter.start(z, params);
  RangeRate rate;
  rate.sigma = 2.0;
  rate.value = 200.0;
  for (int k = 1; k <= 8; ++k) {
    z.x += 800.0;
    filter.update(z, rate, 4.0, params);
  }
  z.x += 600.0;  // 4 s at -25 m/s²: 200 m behind where it was to be
  rate.value = 100.0;
  const double log_likelihood = filter.update(z, rate, 4.0, params);
  EXPECT_NEAR(filter.mean().vx, 100.0, 5.0);
  EXPECT_GT(log_likelihood, -35.0);
}

// If this fails, a target in straight flight is followed worse than one plain Kalman filter would.
TEST(MultipleModelFilter, IsOneKalmanFilterWhenNothingEverTurns) {
  auto generator = seededGenerator();
  MultipleModelParams params = textbook();
  params.straight_time = 1e9;
  params.turning_time = 1e-6;
  MultipleModelFilter filter;
  const PlanarPosition first = randomMeasurement(generator, 10e3, 20e3);
  filter.start(first, params);
  Vector4 x(first.x, first.y, 0.0, 0.0);
  Matrix4 p = Matrix4::Identity() * params.speed_sigma * params.speed_sigma;
  p.topLeftCorner<2, 2>() = denseOf(first.covariance);
  Matrix24 h = Matrix24::Zero();
  h(0, 0) = h(1, 1) = 1.0;
  for (int k = 1; k < 20; ++k) {
    const PlanarPosition z = randomMeasurement(generator, 10e3 + 600.0 * k, 20e3);
    filter.update(z, 4.0, params);
    const Matrix4 f = transition(4.0, 0.0);
    x = f * x;
    p = f * p * f.transpose() + whiteAcceleration(4.0, params.straight_acceleration);
    const Eigen::Matrix2d s = h * p * h.transpose() + denseOf(z.covariance);
    const Eigen::Matrix<double, 4, 2> gain = p * h.transpose() * s.inverse();
    x += gain * (Eigen::Vector2d(z.x, z.y) - h * x);
    p = (Matrix4::Identity() - gain * h) * p;
    // A turn begins within 4 s with a chance of 4e-9; even an innovation of four sigmas leaves it below 1e-4.
    EXPECT_LT((meanOf(filter.mean()) - x).norm(), 0.1);
    EXPECT_GT(filter.straightProbability(), 0.9999);
    expectNear(p, denseOf(filter.predict(0.0, params)), 1e-3);
  }
}

/// One path by small steps: white acceleration and a turn rate.
Vector4 walk(Vector4 s, double dt, double turn_rate, double density, std::mt19937_64& generator) {
  constexpr int kSteps = 100;
  const double step = dt / kSteps;
  std::normal_distribution<double> kick(0.0, std::sqrt(density * step));
  const double c = std::cos(turn_rate * step), sine = std::sin(turn_rate * step);
  for (int i = 0; i < kSteps; ++i) {
    const double vx = s[2], vy = s[3];
    s[2] = c * vx - sine * vy + kick(generator);
    s[3] = sine * vx + c * vy + kick(generator);
    s[0] += 0.5 * step * (vx + s[2]);
    s[1] += 0.5 * step * (vy + s[3]);
  }
  return s;
}

// If this fails, gates are too narrow (tracks lost) or too wide (tracks stolen).
TEST(MultipleModelFilter, PredictsTheSpreadOfSimulatedFlights) {
  auto generator = seededGenerator();
  constexpr int kFlights = 40000;
  constexpr double kTime = 6.0;
  const MultipleModelParams params = fixedRates();
  PlanarPosition z;
  z.x = 1000.0;
  z.covariance = {90000.0, 20000.0, 40000.0};
  MultipleModelFilter filter;
  filter.start(z, params);
  const Eigen::Matrix2d root = denseOf(z.covariance).llt().matrixL();
  std::normal_distribution<double> normal;
  const double straight = params.straight_time / (params.straight_time + params.turning_time);
  Matrix4 second = Matrix4::Zero();
  Vector4 first = Vector4::Zero();
  for (int i = 0; i < kFlights; ++i) {
    const Eigen::Vector2d position =
        Eigen::Vector2d(z.x, z.y) + root * Eigen::Vector2d(normal(generator), normal(generator));
    const Vector4 begin(position[0], position[1], params.speed_sigma * normal(generator),
                        params.speed_sigma * normal(generator));
    const double u = uniform(generator, 0.0, 1.0);
    const double rate = u < straight ? 0.0 : (u < 0.5 * (1.0 + straight) ? params.turn_rate : -params.turn_rate);
    const Vector4 end =
        walk(begin, kTime, rate, rate == 0.0 ? params.straight_acceleration : params.turning_acceleration, generator);
    first += end / kFlights;
    second += end * end.transpose() / kFlights;
  }
  // The standard error of a variance is √(2/40000) = 0.7 %, of all of them together in this norm about the same.
  expectNear(second - first * first.transpose(), denseOf(filter.predict(kTime, params)), 0.03);
}

// If this fails, the chance of existence weighs evidence by a wrong scale, and false tracks live or true ones die.
TEST(MultipleModelFilter, GivesALikelihoodThatSumsUpToOne) {
  MultipleModelParams params = textbook();
  params.speed_sigma = 30.0;
  PlanarPosition z;
  z.covariance = {10000.0, 3000.0, 20000.0};
  MultipleModelFilter started;
  started.start(z, params);
  constexpr double kCell = 25.0, kReach = 2000.0;
  double sum = 0.0;
  for (int i = 0; i < 160; ++i) {
    for (int j = 0; j < 160; ++j) {
      MultipleModelFilter filter = started;
      z.x = -kReach + kCell * i;
      z.y = -kReach + kCell * j;
      sum += std::exp(filter.update(z, 5.0, params)) * kCell * kCell;
    }
  }
  EXPECT_NEAR(sum, 1.0, 1e-3);
}

/// Mean of the normalised squared error of the four state components after some updates, over many flights.
double meanSquaredError(const MultipleModelParams& params, bool turns, std::mt19937_64& generator) {
  constexpr int kFlights = 500, kUpdates = 15;
  constexpr double kStep = 4.0;
  std::normal_distribution<double> normal;
  double sum = 0.0;
  for (int flight = 0; flight < kFlights; ++flight) {
    Vector4 truth(50e3, 20e3, params.speed_sigma * normal(generator), params.speed_sigma * normal(generator));
    const double straight = params.straight_time / (params.straight_time + params.turning_time);
    int model = turns && uniform(generator, 0.0, 1.0) > straight ? 1 : 0;
    MultipleModelFilter filter;
    for (int k = 0; k <= kUpdates; ++k) {
      if (k > 0) {
        const double u = uniform(generator, 0.0, 1.0);
        const double change = 1.0 - std::exp(-kStep / (model == 0 ? params.straight_time : params.turning_time));
        if (turns && u < change) model = model == 0 ? (u < change / 2.0 ? 1 : 2) : 0;
        const double rate = model == 0 ? 0.0 : (model == 1 ? params.turn_rate : -params.turn_rate);
        truth = walk(truth, kStep, rate, model == 0 ? params.straight_acceleration : params.turning_acceleration,
                     generator);
      }
      PlanarPosition z;
      z.x = truth[0] + 100.0 * normal(generator);
      z.y = truth[1] + 250.0 * normal(generator);
      z.covariance = {1e4, 0.0, 62500.0};
      if (k == 0) {
        filter.start(z, params);
      } else {
        filter.update(z, kStep, params);
      }
    }
    const PlanarMotion now = filter.predict(0.0, params);
    const Vector4 error = truth - meanOf(now);
    sum += error.dot(denseOf(now).inverse() * error) / kFlights;
  }
  return sum;
}

// If this fails, the covariance that consumers of the tracks see is a lie for straight flights.
TEST(MultipleModelFilter, KnowsItsOwnErrorInStraightFlight) {
  auto generator = seededGenerator();
  MultipleModelParams params = textbook();
  params.straight_time = 1e6;
  params.turning_time = 0.1;
  // χ² with 4 · 500 degrees of freedom, divided by 500: 4 ± 0.126; four standard deviations.
  EXPECT_NEAR(meanSquaredError(params, false, generator), 4.0, 0.51);
}

// The mixture is merged into Gaussians, so that exact consistency cannot be asked for in turns: within a quarter.
TEST(MultipleModelFilter, KnowsItsOwnErrorRoughlyInTurns) {
  auto generator = seededGenerator();
  const double error = meanSquaredError(fixedRates(), true, generator);
  EXPECT_GT(error, 3.0);
  EXPECT_LT(error, 5.0);
}

}  // namespace
}  // namespace tws
