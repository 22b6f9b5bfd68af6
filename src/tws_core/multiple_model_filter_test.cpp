#include <tws_core/multiple_model_filter.h>

#include <gtest/gtest.h>

#include <numeric>

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

TEST(PlanarPosition, TurnsRangeAndAzimuthErrorsIntoThePlane) {
  // Due east: range is x, cross-range is y.
  const PlanarPosition east = planarMeasurement(100e3, kPi / 2.0, 50.0, 0.005);
  EXPECT_NEAR(east.x, 100e3, 1e-6);
  EXPECT_NEAR(east.y, 0.0, 1e-6);
  EXPECT_NEAR(east.covariance.xx, 2500.0, 1e-6);
  EXPECT_NEAR(east.covariance.yy, 250000.0, 1e-6);
  EXPECT_NEAR(east.covariance.xy, 0.0, 1e-6);
  // North-east: both mixed, xy = (along - cross) / 2.
  const PlanarPosition between = planarMeasurement(100e3, kPi / 4.0, 50.0, 0.005);
  EXPECT_NEAR(between.covariance.xx, 126250.0, 1e-6);
  EXPECT_NEAR(between.covariance.xy, -123750.0, 1e-6);
}

TEST(Symmetric2, GivesTheSquaredDistanceInStandardDeviations) {
  EXPECT_DOUBLE_EQ((Symmetric2{4.0, 0.0, 9.0}).mahalanobis(4.0, 3.0), 5.0);
  // [2 1; 1 2]⁻¹ = [2 -1; -1 2] / 3
  EXPECT_DOUBLE_EQ((Symmetric2{2.0, 1.0, 2.0}).mahalanobis(1.0, 1.0), 2.0 / 3.0);
}

}  // namespace
}  // namespace tws
