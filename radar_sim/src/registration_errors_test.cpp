#include "registration_errors.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/geometry.h>
#include <tws_core/units.h>

namespace radar_sim {
namespace {

using tws::radians;

// By hand: 0.5° of bias, the whole 0.2° of the sine where azimuth and phase add up to 90°, none where they are 0, less
// where they are 270°; a degree an hour is 0.1° in 6 minutes.
TEST(AzimuthErrors, AreTheirSum) {
  AzimuthErrors errors;
  errors.bias = radians(0.5);
  errors.eccentricity = radians(0.2);
  errors.eccentricity_phase = radians(30.0);
  EXPECT_NEAR(errors.at(radians(60.0), 0.0), radians(0.7), 1e-12);
  EXPECT_NEAR(errors.at(radians(-30.0), 0.0), radians(0.5), 1e-12);
  EXPECT_NEAR(errors.at(radians(240.0), 0.0), radians(0.3), 1e-12);
  errors.north_drift = radians(1.0) / 3600.0;
  EXPECT_NEAR(errors.at(radians(240.0), 360.0), radians(0.4), 1e-12);
}

TEST(ClockErrors, GrowWithTheTime) {
  const ClockErrors clock{0.25, -50e-6};
  EXPECT_DOUBLE_EQ(clock.at(0.0), 0.25);
  EXPECT_NEAR(clock.at(1000.0), 0.2, 1e-12);
}

// 100 km and a hundred millionth parts more are 100 010 m, less 25 m.
TEST(RegistrationErrors, StretchAndShiftTheRange) {
  RegistrationErrors errors;
  EXPECT_EQ(errors.rangeMeasured(123456.7), 123456.7);
  errors.range_gain = 1e-4;
  errors.range_bias = -25.0;
  EXPECT_NEAR(errors.rangeMeasured(100e3), 99985.0, 1e-9);
}

TEST(RegistrationErrors, DelayByTheAirWhereTheyAreToldTo) {
  RegistrationErrors errors;
  EXPECT_EQ(errors.delayOf(25.0, 10e3, 400e3), 0.0);
  errors.air_delays = true;
  EXPECT_NEAR(errors.delayOf(25.0, 10e3, 400e3), 84.911, 1e-3);
}

tws::Polar seenFrom(const RegistrationErrors& errors, double east, double north, double up) {
  return tws::polarFromEnu(errors.toAntenna(Eigen::Isometry3d::Identity()) * Eigen::Vector3d(east, north, up));
}

// An axis that leans by 1° to the north. By hand: what stands in the north on the horizon appears 1° up, in the south
// 1° down, in the east where it is. In the east at 45° the antenna's plane cuts the vertical at atan(sin 1°) = 0.99985°
// off: the azimuth is 90.99985°; in the west it is 269.00015°.
TEST(RegistrationErrors, TiltTheAxisOfRotation) {
  RegistrationErrors errors;
  errors.tilt = radians(1.0);
  EXPECT_NEAR(seenFrom(errors, 0.0, 1.0, 0.0).elevation, radians(1.0), 1e-12);
  EXPECT_NEAR(seenFrom(errors, 0.0, -1.0, 0.0).elevation, radians(-1.0), 1e-12);
  EXPECT_NEAR(seenFrom(errors, 1.0, 0.0, 0.0).elevation, 0.0, 1e-12);
  EXPECT_NEAR(seenFrom(errors, 1.0, 0.0, 0.0).azimuth, radians(90.0), 1e-12);
  EXPECT_NEAR(seenFrom(errors, 1.0, 0.0, 1.0).azimuth, radians(90.0) + std::atan(std::sin(radians(1.0))), 1e-12);
  EXPECT_NEAR(seenFrom(errors, -1.0, 0.0, 1.0).azimuth, radians(269.00015), 1e-6);
  errors.tilt_azimuth = radians(90.0);
  EXPECT_NEAR(seenFrom(errors, 1.0, 0.0, 0.0).elevation, radians(1.0), 1e-12);
  EXPECT_NEAR(seenFrom(errors, 0.0, 1.0, 1.0).azimuth, radians(359.00015), 1e-6);
  EXPECT_NEAR(seenFrom(errors, 3.0, 4.0, 12.0).range, 13.0, 1e-12);
}

}  // namespace
}  // namespace radar_sim
