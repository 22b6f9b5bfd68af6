#include "tws_core/registration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include <Eigen/Dense>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>

namespace tws {
namespace {

// If these fail, radars that disagree are not aligned, or radars that agree are bent.

constexpr double kSigmaRange = 100.0, kSigmaAzimuth = 0.005;

/// One target at a place that two radars at (0, 0) and (east, 0) see, with errors.
class Sky {
 public:
  explicit Sky(double east = 0.0) : east_(east) {}

  RegistrationTerms first{}, second{};

  RegistrationPairing pairingAt(double x, double y, double vx, double vy) {
    RegistrationPairing p;
    double variance[2][3] = {};
    double place[2][2] = {};
    const RegistrationTerms* errors[2] = {&first, &second};
    RegistrationRows* rows[2] = {&p.first, &p.second};
    for (std::size_t i = 0; i < 2; ++i) {
      const double at = i == 0 ? 0.0 : east_, range = std::hypot(x - at, y), azimuth = std::atan2(x - at, y);
      *rows[i] = registrationRows(i, range, range, azimuth, azimuth, vx, vy);
      const double seen_range = range + rangeError(*errors[i], range) + kSigmaRange * normal_(generator_);
      const double seen_azimuth = azimuth + azimuthError(*errors[i], azimuth) + kSigmaAzimuth * normal_(generator_);
      place[i][0] = at + seen_range * std::sin(seen_azimuth) - (*errors[i])[kClockOffset] * vx;
      place[i][1] = seen_range * std::cos(seen_azimuth) - (*errors[i])[kClockOffset] * vy;
      const PlanarPosition z = planarMeasurement(range, azimuth, kSigmaRange, kSigmaAzimuth);
      variance[i][0] = z.covariance.xx, variance[i][1] = z.covariance.xy, variance[i][2] = z.covariance.yy;
    }
    p.x = place[0][0] - place[1][0];
    p.y = place[0][1] - place[1][1];
    p.covariance = {variance[0][0] + variance[1][0], variance[0][1] + variance[1][1], variance[0][2] + variance[1][2]};
    return p;
  }

  RegistrationPairing anywhere() {
    const double azimuth = uniform(generator_, 0.0, kTwoPi), range = uniform(generator_, 10e3, 90e3);
    const double course = uniform(generator_, 0.0, kTwoPi);
    return pairingAt(range * std::sin(azimuth), range * std::cos(azimuth), 200.0 * std::sin(course),
                     200.0 * std::cos(course));
  }

 private:
  double east_;
  std::mt19937_64 generator_ = seededGenerator();
  std::normal_distribution<double> normal_;
};

/// Feeds `seconds` of eight pairings each.
void watch(Registration& registration, Sky& sky, double from, double seconds) {
  for (int i = 0; i < 8 * static_cast<int>(seconds); ++i) {
    const double time = from + i / 8.0;
    registration.advance(time);
    RegistrationPairing pairing = sky.anywhere();
    pairing.time = time;
    registration.add(pairing);
  }
}

TEST(RegistrationRows, FollowTheErrorsOfAPlotByHand) {
  // 50 km due east: range is east, azimuth is south.
  const RegistrationRows rows = registrationRows(0, 50e3, 50e3, 0.5 * kPi, 0.5 * kPi, 100.0, -30.0);
  EXPECT_NEAR(rows.x[kRangeBias], 1.0, 1e-12);
  EXPECT_NEAR(rows.x[kRangeGain], 50e3, 1e-6);
  EXPECT_NEAR(rows.y[kAzimuthBias], -50e3, 1e-6);
  EXPECT_NEAR(rows.y[kAzimuthSine], -50e3, 1e-6);
  EXPECT_NEAR(rows.y[kAzimuthCosine], 0.0, 1e-6);
  EXPECT_NEAR(rows.x[kClockOffset], -100.0, 1e-12);
  EXPECT_NEAR(rows.y[kClockOffset], 30.0, 1e-12);
}

TEST(RegistrationFilter, IsTheLeastSquaresSolution) {
  RegistrationParams params;
  params.drift = {};
  params.gate = 1e6;
  RegistrationFilter filter(2, params);
  Sky sky(40e3);
  sky.second = {-194.0, 1e-4, -0.0093, 0.001, -0.0005, 0.3};
  Eigen::MatrixXd information = Eigen::MatrixXd::Zero(12, 12);
  Eigen::VectorXd vector = Eigen::VectorXd::Zero(12);
  for (Eigen::Index i = 0; i < 12; ++i)
    information(i, i) =
        1.0 / (params.sigma[static_cast<std::size_t>(i % 6)] * params.sigma[static_cast<std::size_t>(i % 6)]);
  for (int i = 0; i < 60; ++i) {
    const RegistrationPairing p = sky.anywhere();
    Eigen::Matrix<double, 2, 12> H;
    for (std::size_t k = 0; k < 6; ++k) {
      const auto column = static_cast<Eigen::Index>(k);
      H.col(column) << p.first.x[k], p.first.y[k];
      H.col(column + 6) << -p.second.x[k], -p.second.y[k];
    }
    Eigen::Matrix2d R;
    R << p.covariance.xx, p.covariance.xy, p.covariance.xy, p.covariance.yy;
    information += H.transpose() * R.inverse() * H;
    vector += H.transpose() * R.inverse() * Eigen::Vector2d(p.x, p.y);
    ASSERT_TRUE(filter.add(p));
  }
  const Eigen::MatrixXd covariance = information.inverse();
  const Eigen::VectorXd mean = covariance * vector;
  for (Eigen::Index i = 0; i < 12; ++i) {
    EXPECT_NEAR(filter.mean()[i], mean[i], 1e-5 * std::sqrt(covariance(i, i)));
    EXPECT_NEAR(filter.covariance()(i, i), covariance(i, i), 1e-6 * covariance(i, i));
  }
}

TEST(Registration, OfOneSiteFindsTheDifferenceAndSaysThatItIsOne) {
  Sky sky;
  sky.second = {-194.0, 0.0, -0.0093, 0.0, 0.0, 0.3};
  Registration registration(2, {});
  watch(registration, sky, 0.0, 180.0);
  const auto& reports = registration.reports();
  EXPECT_NEAR(reports[1].errors[kRangeBias] - reports[0].errors[kRangeBias], -194.0, 30.0);
  EXPECT_NEAR(reports[1].applied[kAzimuthBias] - reports[0].applied[kAzimuthBias], -0.0093, 0.0009);
  EXPECT_NEAR(reports[1].applied[kClockOffset] - reports[0].applied[kClockOffset], 0.3, 0.06);
  EXPECT_NEAR(reports[1].errors[kAzimuthBias], -reports[0].errors[kAzimuthBias], 1e-6);
  EXPECT_TRUE(reports[1].relative_only);
  EXPECT_EQ(reports[1].state, RegistrationState::kApplied);
}

TEST(Registration, OfTwoSitesFindsWhoIsWrong) {
  Sky sky(60e3);
  sky.second = {0.0, 0.0, 0.012, 0.0, 0.0, 0.0};
  Registration registration(2, {});
  watch(registration, sky, 0.0, 300.0);
  EXPECT_NEAR(registration.applied(1)[kAzimuthBias], 0.012, 0.0012);
  EXPECT_NEAR(registration.applied(0)[kAzimuthBias], 0.0, 0.0012);
}

TEST(Registration, OfRadarsWithoutErrorsAppliesHardlyAnything) {
  Sky sky;
  Registration registration(2, {});
  watch(registration, sky, 0.0, 600.0);
  EXPECT_LT(std::abs(registration.applied(1)[kAzimuthBias]), 2e-4);
  EXPECT_LT(std::abs(registration.applied(1)[kRangeBias]), 10.0);
  EXPECT_LT(std::abs(registration.applied(1)[kClockOffset]), 0.02);
}

TEST(Registration, AppliesNothingOfWhatOneRadialFlightTells) {
  Sky sky;
  sky.second = {-194.0, 0.0, -0.0093, 0.0, 0.0, 0.3};
  Registration registration(2, {});
  for (int i = 0; i < 300; ++i) {
    registration.advance(i);
    RegistrationPairing pairing = sky.pairingAt(0.0, 80e3 - 200.0 * i, 0.0, -200.0);
    pairing.time = i;
    registration.add(pairing);
  }
  EXPECT_EQ(registration.reports()[1].state, RegistrationState::kUnobservable);
  EXPECT_EQ(registration.applied(1), RegistrationTerms{});
  EXPECT_EQ(registration.applied(0), RegistrationTerms{});
}

TEST(Registration, LeavesWrongPairsOut) {
  Sky sky;
  sky.second = {0.0, 0.0, 0.00873, 0.0, 0.0, 0.0};
  Registration registration(2, {});
  auto generator = seededGenerator();
  for (int i = 0; i < 2400; ++i) {
    registration.advance(0.1 * i);
    RegistrationPairing pairing = sky.anywhere();
    pairing.time = 0.1 * i;
    if (i % 7 == 0) pairing.x += uniform(generator, -5e3, 20e3);
    registration.add(pairing);
  }
  const auto& reports = registration.reports();
  EXPECT_GT(reports[0].rejected, 150U);
  EXPECT_NEAR(reports[1].errors[kAzimuthBias] - reports[0].errors[kAzimuthBias], 0.00873, 0.0009);
}

TEST(Registration, FollowsASlowDriftOfNorth) {
  Sky sky;
  Registration registration(2, {});
  watch(registration, sky, 0.0, 120.0);
  const double rate = radians(1.0) / 3600.0;
  double time = 120.0;
  for (; time < 1320.0; time += 10.0) {
    sky.second[kAzimuthBias] = rate * (time - 120.0);
    watch(registration, sky, time, 10.0);
  }
  const double found = registration.applied(1)[kAzimuthBias] - registration.applied(0)[kAzimuthBias];
  EXPECT_NEAR(found, sky.second[kAzimuthBias], radians(0.07));
}

TEST(Registration, BeginsAnewWhenARadarWasTurned) {
  Sky sky;
  Registration registration(2, {});
  watch(registration, sky, 0.0, 200.0);
  sky.second[kAzimuthBias] = radians(2.5);
  watch(registration, sky, 200.0, 300.0);
  EXPECT_NEAR(registration.applied(1)[kAzimuthBias] - registration.applied(0)[kAzimuthBias], radians(2.5),
              radians(0.2));
}

TEST(Registration, LeavesAnErrorThatIsTooLargeAlone) {
  Sky sky;
  sky.second[kAzimuthBias] = radians(2.0);
  RegistrationParams params;
  params.greatest[kAzimuthBias] = radians(0.5);
  Registration registration(2, params);
  watch(registration, sky, 0.0, 100.0);
  EXPECT_EQ(registration.reports()[1].state, RegistrationState::kTooLarge);
  EXPECT_EQ(registration.applied(1)[kAzimuthBias], 0.0);
}

TEST(Registration, AReferenceTellsAbsoluteErrors) {
  RegistrationParams params;
  Registration registration(1, params);
  auto generator = seededGenerator();
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    registration.advance(i);
    const double azimuth = 0.5 * (i % 12), range = 20e3 + 15e3 * (i % 5);
    RegistrationPairing p;
    p.time = i;
    p.first = registrationRows(0, range, range, azimuth, azimuth, 0.0, 0.0);
    p.absolute = true;
    p.x = -150.0 * p.first.x[kRangeBias] + 0.01 * p.first.x[kAzimuthBias] + 50.0 * normal(generator);
    p.y = -150.0 * p.first.y[kRangeBias] + 0.01 * p.first.y[kAzimuthBias] + 50.0 * normal(generator);
    p.covariance = {2500.0, 0.0, 2500.0};
    registration.add(p);
  }
  EXPECT_NEAR(registration.applied(0)[kAzimuthBias], 0.01, 0.0005);
  EXPECT_NEAR(registration.applied(0)[kRangeBias], -150.0, 30.0);
  EXPECT_FALSE(registration.reports()[0].relative_only);
}

TEST(Registration, StaysWhereItIsWhenFrozenAndDoesNothingWhenOff) {
  Sky sky;
  sky.second[kAzimuthBias] = radians(1.0);
  Registration registration(2, {});
  watch(registration, sky, 0.0, 100.0);
  registration.setMode(RegistrationMode::kFreeze);
  const RegistrationTerms frozen = registration.applied(1);
  sky.second[kAzimuthBias] = radians(1.3);
  watch(registration, sky, 100.0, 100.0);
  EXPECT_EQ(registration.applied(1), frozen);
  EXPECT_EQ(registration.reports()[1].state, RegistrationState::kFrozen);
  registration.setMode(RegistrationMode::kOff);
  EXPECT_FALSE(registration.wantsPairing(200.0));
}

TEST(Registration, GoesOnFromAnotherRun) {
  Sky sky;
  sky.second[kAzimuthBias] = radians(1.0);
  Registration before(2, {}), after(2, {});
  watch(before, sky, 0.0, 100.0);
  after.load(before.filter().mean(), before.filter().covariance());
  EXPECT_NEAR(after.applied(1)[kAzimuthBias] - after.applied(0)[kAzimuthBias], radians(1.0), radians(0.05));
  Eigen::MatrixXd broken = before.filter().covariance();
  broken(0, 0) = -1.0;
  EXPECT_THROW(after.load(before.filter().mean(), broken), std::invalid_argument);
  broken(0, 0) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(after.load(before.filter().mean(), broken), std::invalid_argument);
}

}  // namespace
}  // namespace tws
