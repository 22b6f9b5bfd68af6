#include <tws_core/filter_gains.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <vector>

#include <tws_core/random_test_helpers.h>

namespace tws {
namespace {

/// How the error of a filter goes on from one update to the next, T = 1: (I - K·H)·F.
Eigen::Matrix3d errorTransition(const FilterGains& gains) {
  Eigen::Matrix3d F;
  F << 1.0, 1.0, 0.5, 0.0, 1.0, 1.0, 0.0, 0.0, 1.0;
  const Eigen::Vector3d K(gains.alpha, gains.beta, gains.gamma);
  return F - K * F.row(0);
}

/// What an error has grown by after 2^40 updates, an update: the greatest absolute value of the poles. (Eigen's
/// eigenvalues take the compiler eight seconds.)
double greatestPole(const FilterGains& gains) {
  const int n = degreeOf(gains) + 1;
  Eigen::Matrix3d power = Eigen::Matrix3d::Zero();
  power.topLeftCorner(n, n) = errorTransition(gains).topLeftCorner(n, n);
  double log_growth = 0.0;
  for (double updates = 1.0; updates <= 0x1p40; updates *= 2.0) {
    const double norm = power.norm();
    if (norm == 0.0) return 0.0;
    log_growth += std::log(norm) / updates;
    power /= norm;
    power = (power * power).eval();
  }
  return std::exp(log_growth);
}

// A gain outside the region makes a track run away within a few scans.
TEST(StabilityRegion, IsWhereAllPolesLieInsideTheUnitCircle) {
  auto generator = seededGenerator();
  int stable = 0, compared = 0;
  for (int degree = 0; degree <= 2; ++degree) {
    for (int i = 0; i < 20000; ++i) {
      FilterGains gains{uniform(generator, -0.5, 2.5), 0.0, 0.0};
      if (degree > 0) gains.beta = uniform(generator, -0.5, 4.5);
      if (degree > 1) gains.gamma = uniform(generator, -0.5, 4.5);
      const double pole = greatestPole(gains);
      if (std::abs(pole - 1.0) < 1e-9) continue;  // on the edge
      ASSERT_EQ(isStable(gains), pole < 1.0) << gains.alpha << ' ' << gains.beta << ' ' << gains.gamma;
      stable += pole < 1.0;
      ++compared;
    }
  }
  EXPECT_GT(stable, 5000);
  EXPECT_GT(compared - stable, 5000);
}

// Figure 3.5 of Henery 1985: a triangle with the corners (0, 0), (2, 0) and (0, 4).
TEST(StabilityRegion, OfTheAlphaBetaFilterIsTheTriangleOfFigure35) {
  for (double alpha : {0.01, 0.5, 1.0, 1.5, 1.99}) {
    EXPECT_TRUE(isStable({alpha, 4.0 - 2.0 * alpha - 1e-6, 0.0})) << alpha;
    EXPECT_FALSE(isStable({alpha, 4.0 - 2.0 * alpha + 1e-6, 0.0})) << alpha;
    EXPECT_FALSE(isStable({alpha, -1e-6, 0.0})) << alpha;
    EXPECT_FALSE(isStable({-alpha, 0.5, 0.0})) << alpha;
  }
}

/// Sum of the squares of the impulse response, by stepping the filter: the noise reduction by its definition.
Eigen::Vector3d bruteForceReduction(const FilterGains& gains) {
  const Eigen::Matrix3d step = errorTransition(gains);
  Eigen::Vector3d response(gains.alpha, gains.beta, gains.gamma), sum = Eigen::Vector3d::Zero();
  for (int k = 0; k < 20000; ++k) {
    sum += response.cwiseAbs2();
    response = step * response;
  }
  return sum;
}

TEST(NoiseReduction, IsTheSumOfTheSquaredImpulseResponse) {
  const std::vector<FilterGains> cases{{0.3, 0.0, 0.0},  {1.4, 0.0, 0.0},    {0.5, 0.2, 0.0},  {1.2, 0.9, 0.0},
                                       {0.1, 0.01, 0.0}, {0.7, 0.4, 0.12},   {0.9, 0.95, 0.5}, {0.4, 0.1, 0.01},
                                       {1.5, 0.5, 0.9},  {0.6, 0.27, 0.0628}};
  constexpr double T = 5.0;
  for (const FilterGains& gains : cases) {
    ASSERT_TRUE(isStable(gains));
    const Eigen::Vector3d expected = bruteForceReduction(gains);
    const NoiseReduction actual = noiseReduction(gains, T);
    EXPECT_NEAR(actual.position, expected[0], 1e-9 * expected[0]);
    EXPECT_NEAR(actual.velocity * T * T, expected[1], 1e-9);
    EXPECT_NEAR(actual.acceleration * std::pow(T, 4), expected[2], 1e-9);
  }
}

TEST(NoiseReduction, OfTheAlphaFilterIsAlphaOver2MinusAlpha) {
  EXPECT_DOUBLE_EQ(noiseReduction({0.5, 0.0, 0.0}, 6.0).position, 0.5 / 1.5);
}

TEST(MeanAge, IsTheAgeOfTheDataWeightedByTheImpulseResponse) {
  for (double alpha : {0.1, 0.5, 0.9}) {
    double age = 0.0;
    for (int k = 0; k < 1000; ++k) age += k * alpha * std::pow(1.0 - alpha, k);
    EXPECT_NEAR(meanAge(alpha), age, 1e-9) << alpha;
  }
}

// 200 m/s seen every 6 s with α = 0.4: 1200 m a scan, times 0.6 / 0.4.
TEST(Lag, OfTheAlphaFilterIsEquation37WorkedOutByHand) {
  EXPECT_DOUBLE_EQ(smoothedLag({0.4, 0.0, 0.0}, 200.0, 6.0), 1800.0);
  EXPECT_DOUBLE_EQ(predictedLag({0.4, 0.0, 0.0}, 200.0, 6.0), 3000.0);
  EXPECT_DOUBLE_EQ(predictedLag({0.4, 0.2, 0.0}, 10.0, 6.0), 1800.0);
}

/// Weight of the newest of n measurements in their least-squares polynomial at the newest, by the textbook's matrices.
double newestWeight(int degree, int n) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Identity();  // A^T A, beyond the degree left as it is
  const int terms = degree + 1;
  normal.topLeftCorner(terms, terms).setZero();
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < terms; ++k)
      for (int l = 0; l < terms; ++l) normal(k, l) += std::pow(-i, k + l);
  return normal.inverse()(0, 0);  // A's row of the newest is (1, 0, 0)
}

TEST(ExpandingGains, GiveTheNewestMeasurementItsLeastSquaresWeight) {
  EXPECT_DOUBLE_EQ(expandingGains(0, 5).alpha, 0.2);
  for (int degree = 0; degree <= 2; ++degree)
    for (int n = degree + 1; n < 40; ++n)
      EXPECT_NEAR(expandingGains(degree, n).alpha, newestWeight(degree, n), 1e-8) << degree << ' ' << n;
}

TEST(ExpandingGains, BeginWithTheDegreeThatTheMeasurementsDetermine) {
  for (int degree = 0; degree <= 2; ++degree) EXPECT_EQ(expandingGains(degree, 1).alpha, 1.0);
  EXPECT_EQ(expandingGains(2, 2).beta, 1.0);
  EXPECT_EQ(expandingGains(2, 2).gamma, 0.0);
}

// All poles of a fading memory lie at θ: z³ - 3θz² + 3θ²z - θ³ and so on.
TEST(FadingGains, PutAllPolesAtTheta) {
  for (double theta : {0.0, 0.3, 0.8}) {
    for (int degree = 0; degree <= 2; ++degree) {
      const int n = degree + 1;
      Eigen::Matrix3d error = Eigen::Matrix3d::Zero(), power = Eigen::Matrix3d::Identity();
      error.topLeftCorner(n, n) = errorTransition(fadingGains(degree, theta)).topLeftCorner(n, n);
      for (int k = 0; k < n; ++k) power = (power * (error - theta * Eigen::Matrix3d::Identity())).eval();
      EXPECT_LT(power.topLeftCorner(n, n).norm(), 1e-12) << degree << ' ' << theta;  // Cayley and Hamilton
    }
  }
}

// Kalata 1984 and others print these: Λ = 0.1 gives α = 0.36, β = 0.08.
TEST(SteadyGains, HaveKnownValues) {
  EXPECT_NEAR(steadyGains(1, 0.1).alpha, 0.36, 1e-14);
  EXPECT_NEAR(steadyGains(1, 0.1).beta, 0.08, 1e-14);
  EXPECT_NEAR(steadyGains(2, 0.1).gamma, 0.06286821524, 1e-10);  // by stepping the Riccati equation
  EXPECT_NEAR(trackingIndex(20.0, 100.0, 4.0), 3.2, 1e-15);
}

TEST(SteadyGains, FulfilKalatasRelations) {
  for (double index : {1e-6, 1e-3, 0.1, 1.0, 10.0, 1000.0}) {
    const auto [a1, b1, unused] = steadyGains(1, index);
    EXPECT_NEAR(b1 * b1 / (1.0 - a1) / (index * index), 1.0, 1e-8) << index;
    EXPECT_NEAR(2.0 * (2.0 - a1) - 4.0 * std::sqrt(1.0 - a1), b1, 1e-12) << index;
    const auto [a2, b2, g2] = steadyGains(2, index);
    EXPECT_NEAR(g2 * g2 / (1.0 - a2) / (index * index), 1.0, 1e-8) << index;
    EXPECT_NEAR(b2 * b2 / (2.0 * a2), g2, 1e-12) << index;
    for (int degree = 0; degree <= 2; ++degree) EXPECT_TRUE(isStable(steadyGains(degree, index))) << index;
  }
}

TEST(SteadyGains, AreNoneForATargetThatNeverManoeuvres) {
  for (int degree = 0; degree <= 2; ++degree) EXPECT_EQ(steadyGains(degree, 0.0).alpha, 0.0);
}

}  // namespace
}  // namespace tws
