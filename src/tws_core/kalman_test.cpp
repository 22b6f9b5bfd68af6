#include <tws_core/kalman.h>

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include <tws_core/geometry.h>
#include <tws_core/random_test_helpers.h>
#include <tws_core/units.h>

namespace tws {
namespace {

double normal(std::mt19937_64& generator, double sigma) {
  return std::normal_distribution<double>(0.0, sigma)(generator);
}

Eigen::Matrix4d transition(double dt) {
  Eigen::Matrix4d f = Eigen::Matrix4d::Identity();
  f(0, 2) = f(1, 3) = dt;
  return f;
}

// Bar-Shalom, Li and Kirubarajan, "Estimation with applications to tracking and navigation", eq. (6.2.2-12).
Eigen::Matrix4d processNoise(double dt, double q) {
  Eigen::Matrix4d noise = Eigen::Matrix4d::Zero();
  noise(0, 0) = noise(1, 1) = q * dt * dt * dt / 3;
  noise(0, 2) = noise(2, 0) = noise(1, 3) = noise(3, 1) = q * dt * dt / 2;
  noise(2, 2) = noise(3, 3) = q * dt;
  return noise;
}

const Eigen::Matrix<double, 2, 4> kH = Eigen::Matrix<double, 2, 4>::Identity();

// The textbook's update with the Joseph form, dense.
PlanarState josephUpdate(const PlanarState& state, const PlanarMeasurement& z) {
  const Eigen::Matrix2d s = kH * state.covariance * kH.transpose() + z.covariance;
  const Eigen::Matrix<double, 4, 2> gain = state.covariance * kH.transpose() * s.inverse();
  const Eigen::Matrix4d keep = Eigen::Matrix4d::Identity() - gain * kH;
  PlanarState result;
  result.mean = state.mean + gain * (z.position - kH * state.mean);
  result.covariance = keep * state.covariance * keep.transpose() + gain * z.covariance * gain.transpose();
  return result;
}

void expectClose(const Eigen::MatrixXd& actual, const Eigen::MatrixXd& expected, double relative) {
  EXPECT_LE((actual - expected).norm(), relative * expected.norm()) << actual << "\nis not\n" << expected;
}

TEST(PlanarKalman, AgreesWithTheDenseTextbookFilterOverManySteps) {
  auto generator = seededGenerator();
  for (int run = 0; run < 100; ++run) {
    PlanarState state = startState(convertedMeasurement(5e4, uniform(generator, 0, 6.28), 50.0, 0.002), 200.0);
    PlanarState dense = state;
    for (int step = 0; step < 50; ++step) {
      const double dt = uniform(generator, 0.0, 8.0), q = uniform(generator, 0.0, 30.0);
      predict(state, dt, q);
      dense.mean = (transition(dt) * dense.mean).eval();
      dense.covariance = (transition(dt) * dense.covariance * transition(dt).transpose() + processNoise(dt, q)).eval();
      const PlanarMeasurement z =
          convertedMeasurement(uniform(generator, 4e4, 6e4), uniform(generator, 0, 6.28), 50.0, 0.002);
      update(state, z, innovation(state, z));
      dense = josephUpdate(dense, z);
      expectClose(state.mean, dense.mean, 1e-9);
      expectClose(state.covariance, dense.covariance, 1e-9);
      ASSERT_EQ(state.covariance, state.covariance.transpose());
    }
  }
}

// The same against matrices written out for three dimensions: an axis mixed up would make every height wrong.
TEST(SpatialKalman, AgreesWithTheDenseTextbookFilterOverManySteps) {
  using Matrix6d = Eigen::Matrix<double, 6, 6>;
  const Eigen::Matrix<double, 3, 6> h = Eigen::Matrix<double, 3, 6>::Identity();
  const Eigen::Matrix3d one = Eigen::Matrix3d::Identity();
  auto generator = seededGenerator();
  const auto measure = [&] {
    Eigen::Matrix3d root;
    for (double& value : root.reshaped()) value = uniform(generator, -50.0, 50.0);
    return SpatialMeasurement{Eigen::Vector3d(uniform(generator, 0.0, 9e4), uniform(generator, 0.0, 9e4), 5e3),
                              root * root.transpose() + 25.0 * one};
  };
  for (int run = 0; run < 50; ++run) {
    SpatialState state = startState(measure(), 200.0);
    SpatialState dense = state;
    for (int step = 0; step < 50; ++step) {
      const double dt = uniform(generator, 0.0, 8.0), q = uniform(generator, 1.0, 30.0);
      Matrix6d f = Matrix6d::Identity(), noise;
      f.topRightCorner<3, 3>() = dt * one;
      noise << q * dt * dt * dt / 3 * one, q * dt * dt / 2 * one, q * dt * dt / 2 * one, q * dt * one;
      predict(state, dt, q);
      const SpatialMeasurement z = measure();
      update(state, z, innovation(state, z));
      const Matrix6d p = f * dense.covariance * f.transpose() + noise;
      const Eigen::Matrix<double, 6, 3> gain = p * h.transpose() * (h * p * h.transpose() + z.covariance).inverse();
      const Matrix6d keep = Matrix6d::Identity() - gain * h;
      dense.mean = (f * dense.mean + gain * (z.position - h * f * dense.mean)).eval();
      dense.covariance = keep * p * keep.transpose() + gain * z.covariance * gain.transpose();
      expectClose(state.mean, dense.mean, 1e-8);
      expectClose(state.covariance, dense.covariance, 1e-8);
      ASSERT_EQ(state.covariance, state.covariance.transpose());
    }
  }
}

// Each axis of the planar filter is a filter of its own: along x alone it must do the same.
TEST(LinearKalman, DoesWhatThePlanarFilterDoesAlongOneAxis) {
  auto generator = seededGenerator();
  const auto measurement = [](double place) {
    LinearMeasurement z;
    z.position << place;
    z.covariance << 25.0;
    return z;
  };
  LinearState line = startState(measurement(1e3), 50.0);
  PlanarState plane = startState(PlanarMeasurement{{1e3, 0.0}, 25.0 * Eigen::Matrix2d::Identity()}, 50.0);
  for (int step = 0; step < 50; ++step) {
    const double place = 1e3 + uniform(generator, -20.0, 20.0);
    predict(line, 0.1, 7.0);
    predict(plane, 0.1, 7.0);
    const PlanarMeasurement planar{{place, 0.0}, 25.0 * Eigen::Matrix2d::Identity()};
    update(line, measurement(place), innovation(line, measurement(place)));
    update(plane, planar, innovation(plane, planar));
    EXPECT_NEAR(line.mean[0], plane.mean[0], 1e-9);
    EXPECT_NEAR(line.mean[1], plane.mean[2], 1e-9);
    EXPECT_NEAR(line.covariance(1, 1), plane.covariance(2, 2), 1e-9);
  }
}

TEST(PlanarKalman, PredictsInTwoHalvesWhatItPredictsAtOnce) {
  PlanarState once = startState(convertedMeasurement(3e4, 1.0, 40.0, 0.003), 150.0);
  once.mean << 1e4, 2e4, -100.0, 50.0;
  PlanarState twice = once;
  predict(once, 6.0, 9.0);
  predict(twice, 2.5, 9.0);
  predict(twice, 3.5, 9.0);
  expectClose(twice.mean, once.mean, 1e-14);
  expectClose(twice.covariance, once.covariance, 1e-13);
}

TEST(PlanarKalman, AveragesTwoEqualMeasurementsOfAStandingTarget) {
  const PlanarMeasurement first{{100.0, 200.0}, Eigen::Matrix2d::Identity() * 4.0};
  const PlanarMeasurement second{{104.0, 196.0}, Eigen::Matrix2d::Identity() * 4.0};
  PlanarState state = startState(first, 0.0);
  const PlanarInnovation seen = innovation(state, second);
  EXPECT_DOUBLE_EQ(seen.nis, (16.0 + 16.0) / 8.0);
  EXPECT_DOUBLE_EQ(seen.covariance(0, 0), 8.0);
  update(state, second, seen);
  expectClose(state.mean, Eigen::Vector4d(102.0, 198.0, 0.0, 0.0), 1e-15);
  expectClose(state.covariance.topLeftCorner<2, 2>(), Eigen::Matrix2d::Identity() * 2.0, 1e-15);
}

// A covariance that loses its sign makes the gate meaningless and the track jump.
TEST(PlanarKalman, StaysPositiveDefiniteWhenTheMeasurementIsFarMorePreciseThanThePrediction) {
  PlanarState state;
  state.covariance = Eigen::Vector4d(1e12, 1e12, 1e6, 1e6).asDiagonal();
  const PlanarMeasurement z{{1.0, 2.0}, Eigen::Matrix2d::Identity() * 1e-6};
  for (int step = 0; step < 100; ++step) {
    predict(state, 1.0, 1e-3);
    update(state, z, innovation(state, z));
    ASSERT_EQ(state.covariance, state.covariance.transpose());
    ASSERT_EQ(Eigen::LLT<Eigen::Matrix4d>(state.covariance).info(), Eigen::Success) << step;
    // Never less certain than the measurement alone, and R within rounding: products, no lost digits.
    ASSERT_LE(state.covariance(0, 0), 1e-6 * (1 + 1e-9));
  }
}

// The gate's probability is χ²: with a wrong NIS it lets through too few true or too many false plots.
TEST(PlanarKalman, IsConsistentOnTheMotionItAssumes) {
  auto generator = seededGenerator();
  constexpr int kRuns = 200, kSteps = 50;
  constexpr double kDt = 4.0, kQ = 5.0, kSigma = 60.0;
  const Eigen::Matrix4d noise_root = Eigen::LLT<Eigen::Matrix4d>(processNoise(kDt, kQ)).matrixL();
  const Eigen::Matrix2d r = Eigen::Matrix2d::Identity() * kSigma * kSigma;
  double sum = 0.0;
  for (int run = 0; run < kRuns; ++run) {
    Eigen::Vector4d truth(2e4, 3e4, normal(generator, 150.0), normal(generator, 150.0));
    const auto measure = [&] {
      return PlanarMeasurement{truth.head<2>() + Eigen::Vector2d(normal(generator, kSigma), normal(generator, kSigma)),
                               r};
    };
    PlanarState state = startState(measure(), 150.0);
    for (int step = 0; step < kSteps; ++step) {
      Eigen::Vector4d w;
      for (double& value : w) value = normal(generator, 1.0);
      truth = transition(kDt) * truth + noise_root * w;
      predict(state, kDt, kQ);
      const PlanarMeasurement z = measure();
      const PlanarInnovation seen = innovation(state, z);
      sum += seen.nis;
      update(state, z, seen);
    }
  }
  // The sum is χ² with 2n degrees of freedom: mean 2n, standard deviation 2√n; five of them.
  constexpr double kCount = kRuns * kSteps;
  EXPECT_NEAR(sum, 2 * kCount, 5 * 2 * std::sqrt(kCount));
}

struct Moments {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
};

template <class Convert>
Moments conversionError(Convert convert, double range, double azimuth, double sigma_range, double sigma_azimuth,
                        int count) {
  auto generator = seededGenerator();
  Moments moments;
  const Eigen::Vector2d truth = planarFromPolar(range, azimuth);
  for (int i = 0; i < count; ++i) {
    const double r = range + normal(generator, sigma_range), a = azimuth + normal(generator, sigma_azimuth);
    const Eigen::Vector2d error = convert(r, a, sigma_range, sigma_azimuth).position - truth;
    moments.mean += error / count;
    moments.covariance += error * error.transpose() / count;
  }
  return moments;
}

TEST(ConvertedMeasurement, HasTheSpreadOfSimulatedMeasurements) {
  constexpr int kCount = 200000;
  const auto moments = conversionError(convertedMeasurement, 1e5, radians(60.0), 100.0, 0.002, kCount);
  // A sample variance of n has the relative deviation √(2/n) = 0.3 %; five of them.
  expectClose(convertedMeasurement(1e5, radians(60.0), 100.0, 0.002).covariance, moments.covariance, 0.016);
}

// At long range a wide beam pulls the plain conversion inwards: r·σ²/2, here 2 km of 100 km.
TEST(UnbiasedMeasurement, HasNoBiasAndTheSimulatedSpreadWhereThePlainOneHasBoth) {
  constexpr int kCount = 200000;
  constexpr double kSigma = 0.2;
  const Eigen::Vector2d outward = planarFromPolar(1.0, 0.7);
  const auto plain = conversionError(convertedMeasurement, 1e5, 0.7, 500.0, kSigma, kCount);
  const auto unbiased = conversionError(unbiasedMeasurement, 1e5, 0.7, 500.0, kSigma, kCount);
  const double five_deviations = 5.0 * std::sqrt(unbiased.covariance.trace() / kCount);
  EXPECT_NEAR(plain.mean.dot(outward), 1e5 * (std::exp(-0.02) - 1.0), five_deviations);
  EXPECT_LT(unbiased.mean.norm(), five_deviations);
  expectClose(unbiasedMeasurement(1e5, 0.7, 500.0, kSigma).covariance, unbiased.covariance, 0.016);
}

TEST(UnbiasedMeasurement, BecomesThePlainOneForANarrowBeam) {
  const auto plain = convertedMeasurement(5e4, 2.0, 50.0, 1e-4), unbiased = unbiasedMeasurement(5e4, 2.0, 50.0, 1e-4);
  EXPECT_NEAR((plain.position - unbiased.position).norm(), 0.0, 1e-3);
  expectClose(unbiased.covariance, plain.covariance, 1e-5);
}

TEST(ConvertedMeasurement, IsPreciseAlongTheLineOfSightAndVagueAcross) {
  const Eigen::Matrix2d east = convertedMeasurement(1e4, radians(90.0), 10.0, 0.01).covariance;
  EXPECT_NEAR(east(0, 0), 100.0, 1e-9);
  EXPECT_NEAR(east(1, 1), 1e4, 1e-9);
  const Eigen::Matrix2d north_east = convertedMeasurement(1e4, radians(45.0), 10.0, 0.01).covariance;
  EXPECT_NEAR(north_east(0, 1), (100.0 - 1e4) / 2, 1e-9);  // the long axis runs from north-west to south-east
}

}  // namespace
}  // namespace tws
