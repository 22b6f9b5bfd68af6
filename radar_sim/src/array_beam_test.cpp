#include "array_beam.h"

#include <gtest/gtest.h>

#include <cmath>

#include <tws_core/units.h>

namespace radar_sim {
namespace {

ArrayParams array() {
  ArrayParams params;
  params.beamwidth_u = 0.04;
  params.beamwidth_v = 0.02;
  params.reference_snr = 100.0;
  params.reference_range = 100e3;
  params.scan_loss_exponent = 3.0;
  return params;
}

/// Width of the beam in angle between its half-power points [rad], for a beam steered by `scan` in u.
double angularWidth(double scan) {
  const double half = array().beamwidth_u / 2.0, u = std::sin(scan);
  return std::asin(u + half) - std::asin(u - half);
}

// Frame building rests on footprints of the stated beamwidth.
TEST(ArrayBeam, HasHalfItsGainAtHalfABeamwidthInBothDirections) {
  EXPECT_DOUBLE_EQ(beamGain(array(), {0.1, 0.1}, {0.1, 0.1}), 1.0);
  EXPECT_NEAR(beamGain(array(), {0.1, 0.1}, {0.12, 0.1}), 0.5, 1e-12);
  EXPECT_NEAR(beamGain(array(), {0.1, 0.1}, {0.1, 0.09}), 0.5, 1e-12);
}

// At 60 degrees off boresight the aperture looks half as wide, and its beam is twice as wide in angle, to the second
// order of the beamwidth.
TEST(ArrayBeam, BroadensInAngleAsOneOverTheCosineOfTheScanAngle) {
  EXPECT_NEAR(beamGain(array(), {std::sin(tws::radians(60.0)), 0.0}, {std::sin(tws::radians(60.0)) + 0.02, 0.0}), 0.5,
              1e-12);
  EXPECT_NEAR(angularWidth(tws::radians(60.0)) / angularWidth(0.0), 2.0, 0.01);
}

TEST(ArrayBeam, ReferenceTargetHasTheReferenceSnr) {
  EXPECT_NEAR(arraySnr(array(), {0.0, 0.0}, {0.0, 0.0}, 100e3, 1.0), 100.0, 1e-9);
}

// Twice the range costs 12 dB, half-power beam shape 6 dB both ways, a scan of 60 degrees with cos^3 9 dB.
TEST(ArrayBeam, LosesPowerByRangeBeamShapeAndScan) {
  EXPECT_NEAR(arraySnr(array(), {0.0, 0.0}, {0.0, 0.0}, 200e3, 1.0), 100.0 / 16.0, 1e-9);
  EXPECT_NEAR(arraySnr(array(), {0.0, 0.0}, {0.0, 0.0}, 100e3, 3.0), 300.0, 1e-9);
  EXPECT_NEAR(arraySnr(array(), {0.02, 0.0}, {0.0, 0.0}, 100e3, 1.0), 25.0, 1e-9);
  const double u = std::sin(tws::radians(60.0));
  EXPECT_NEAR(arraySnr(array(), {u, 0.0}, {u, 0.0}, 100e3, 1.0), 100.0 / 8.0, 1e-9);
}

TEST(ArrayBeam, HearsNothingFromBesideTheMainLobeNorFromBehindTheFace) {
  EXPECT_EQ(arraySnr(array(), {0.0, 0.0}, {0.041, 0.0}, 1e3, 1e6), 0.0);
  EXPECT_EQ(arraySnr(array(), {0.99, 0.0}, {0.99, 0.2}, 1e3, 1e6), 0.0);
}

TEST(ArrayBeam, IsNotSteeredFurtherThanTheArrayScans) {
  EXPECT_TRUE(canSteer(array(), {0.6, 0.6}));
  EXPECT_FALSE(canSteer(array(), {0.7, 0.6}));
}

// Barton: a cell over 1.6 sqrt(2 S); at S = 50 that is a sixteenth.
TEST(ArrayBeam, MeasuresTheBetterTheStrongerTheEchoDownToAFloor) {
  EXPECT_NEAR(arraySigma(0.0, 30.0, 50.0), 30.0 / 16.0, 1e-12);
  EXPECT_NEAR(arraySigma(2.0, 24.0, 50.0), 2.5, 1e-12);
}

}  // namespace
}  // namespace radar_sim
