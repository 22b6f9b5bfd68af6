#include "beam_tests.h"

#include <gtest/gtest.h>

#include "dwell_test_helpers.h"

namespace esa_frame_builder {
namespace {

Dwell beam(double u, double v, double beamwidth_u, double beamwidth_v) {
  Dwell dwell = dwellAt(0.0, u, v);
  dwell.beamwidth_u = beamwidth_u;
  dwell.beamwidth_v = beamwidth_v;
  return dwell;
}

SpannedDwell spanned(const Dwell& dwell) { return {dwell, rangeSpanOf(dwell)}; }
SpannedDwell rangesAt(double time, const std::vector<double>& ranges) {
  Dwell dwell = dwellAt(time, 0.0, 0.0);
  for (double range : ranges) dwell.measurements.push_back(measurementAt(range, 0.0, 0.0));
  return spanned(dwell);
}

TEST(BeamTests, CoarseTestComparesBeamPointsInWidthsOfTheNewBeam) {
  FrameBuilderParams params;
  params.gamma_u = params.gamma_v = 0.8;  // By hand: 0.016 in u, 0.024 in v.
  const Dwell k = beam(0.1, 0.0, 0.02, 0.03);
  EXPECT_TRUE(beamPointsAreClose(k, beam(0.115, 0.02, 0.001, 0.001), params));
  EXPECT_FALSE(beamPointsAreClose(k, beam(0.117, 0.02, 0.5, 0.5), params));
  EXPECT_FALSE(beamPointsAreClose(k, beam(0.115, 0.025, 0.5, 0.5), params));
  EXPECT_FALSE(beamPointsAreClose(k, beam(0.085, -0.025, 0.5, 0.5), params));
}

// By hand: 300 m/s for 2 s and three standard deviations of the worse measurement, 20 m: 660 m.
TEST(BeamTests, CoarseTestComparesRangesWithinMotionAndError) {
  FrameBuilderParams params;
  params.max_speed = 300.0;
  params.range_gate_chi2 = 9.0;
  SpannedDwell k = rangesAt(3.0, {52000.0, 50000.0});
  k.dwell.measurements[1].covariance(0, 0) = 400.0;
  k.span = rangeSpanOf(k.dwell);
  EXPECT_DOUBLE_EQ(k.span.sigma, 20.0);
  EXPECT_TRUE(rangesMeet(k, rangesAt(1.0, {60000.0, 52659.0}), params));
  EXPECT_FALSE(rangesMeet(k, rangesAt(1.0, {60000.0, 52661.0}), params));
  EXPECT_TRUE(rangesMeet(k, rangesAt(5.0, {40000.0, 49341.0}), params));
  EXPECT_FALSE(rangesMeet(k, rangesAt(5.0, {40000.0, 49339.0}), params));
}

// Nobody knows where the targets of an empty dwell would have been: only its beam tells.
TEST(BeamTests, ADwellWithoutMeasurementsPassesTheRangeGate) {
  const FrameBuilderParams params;
  EXPECT_TRUE(rangesMeet(rangesAt(0.0, {}), rangesAt(0.0, {50000.0}), params));
  EXPECT_TRUE(rangesMeet(rangesAt(0.0, {50000.0}), rangesAt(0.0, {}), params));
  EXPECT_TRUE(passesCoarseTest(rangesAt(0.0, {}), rangesAt(0.0, {}), params));
}

// By hand: 0.3 and 0.4 beamwidths apart are 0.5 beamwidths.
TEST(BeamTests, FineTestMeasuresTheSeparationInBeamwidths) {
  FrameBuilderParams params;
  const Dwell k = beam(0.1, 0.1, 0.02, 0.03), n = beam(0.106, 0.088, 0.5, 0.5);
  params.gamma_theta = 0.49;
  EXPECT_TRUE(passesFineTest(k, n, params));
  params.gamma_theta = 0.51;
  EXPECT_FALSE(passesFineTest(k, n, params));
}

// If this fails, a frame closes although nothing can be in it twice, or stays open although everything is.
TEST(BeamTests, MergingIsRejectedOnlyWhereBeamAndRangeMeet) {
  const FrameBuilderParams params;
  EXPECT_TRUE(beamPointTestRejects(rangesAt(0.0, {50e3}), rangesAt(0.0, {50e3}), params));
  EXPECT_FALSE(beamPointTestRejects(rangesAt(0.0, {50e3}), rangesAt(0.0, {90e3}), params)) << "the same beam";
  SpannedDwell beside = rangesAt(0.0, {50e3});
  beside.dwell.u += 0.012;  // 0.6 beamwidths: close, but not too close
  EXPECT_TRUE(passesCoarseTest(rangesAt(0.0, {50e3}), beside, params));
  EXPECT_FALSE(beamPointTestRejects(rangesAt(0.0, {50e3}), beside, params));
}

TEST(BeamTests, FootprintsMayShareTargetsUpToBothRadii) {
  FrameBuilderParams params;
  params.alpha_0 = 1.5;  // By hand: radii of 0.03 and 0.045.
  const SpannedDwell a = spanned(beam(0.0, 0.0, 0.02, 0.01)), b = spanned(beam(0.0, 0.074, 0.01, 0.03));
  EXPECT_DOUBLE_EQ(footprintRadius(b.dwell, params), 0.045);
  EXPECT_TRUE(mayShareTargets(a, b, params));
  EXPECT_FALSE(mayShareTargets(a, spanned(beam(0.0, 0.076, 0.01, 0.03)), params));
}

}  // namespace
}  // namespace esa_frame_builder
