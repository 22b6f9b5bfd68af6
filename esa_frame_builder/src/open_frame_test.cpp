#include "open_frame.h"

#include <gtest/gtest.h>

#include "dwell_test_helpers.h"

namespace esa_frame_builder {
namespace {

constexpr double kPeriod = 0.1;  // T_rp [s]

SpannedDwell spanned(const Dwell& dwell) { return {dwell, rangeSpanOf(dwell)}; }
SpannedDwell at(double time, double range) {
  return spanned(dwellAt(time, 0.0, 0.0, {measurementAt(range, 0.0, 0.0)}));
}

Dwell expecting(const std::vector<std::uint32_t>& tracks) {
  Dwell dwell = dwellAt(0.0, 0.0, 0.0);
  dwell.group_indices = tracks;
  return dwell;
}

TEST(OpenFrame, IsTooOldAfterItsGreatestTimeFromItsEarliestDwell) {
  FrameBuilderParams params;
  params.max_frame_time = 0.5;
  OpenFrame frame(0, params);
  EXPECT_FALSE(frame.isTooOldFor(1e9)) << "an empty frame";
  frame.add(at(10.25, 50e3));
  frame.add(at(10.0, 50e3));
  frame.add(at(10.125, 50e3));
  EXPECT_FALSE(frame.isTooOldFor(10.5));
  EXPECT_TRUE(frame.isTooOldFor(10.51));
  EXPECT_FALSE(frame.willGrowStale(10.5));
  EXPECT_TRUE(frame.willGrowStale(10.51));
}

// By hand: Θ_max = 1.5 · 0.03; v_max/r_min = 1000 m/s / 50 km = 0.02 /s; 0.045 / 0.02 /s = 2.25 s.
TEST(OpenFrame, BeamPointsHoldUntilTheFastestTargetHasCrossedTheWidestBeam) {
  FrameBuilderParams params;
  params.alpha_0 = 1.5;
  params.max_speed = 1000.0;
  params.greatest_allowance_periods = 100;
  OpenFrame frame(0, params);
  frame.add(at(4.0, 80e3));
  SpannedDwell widest = at(4.0, 50e3);
  widest.dwell.beamwidth_v = 0.03;
  frame.add(widest);
  frame.add(spanned(dwellAt(4.5, 0.0, 0.0)));
  EXPECT_DOUBLE_EQ(frame.leastRange(), 50e3);
  EXPECT_DOUBLE_EQ(frame.greatestAngularRate(), 0.02);
  EXPECT_NEAR(frame.beamPointAllowance(kPeriod), 2.25, 1e-12);
  EXPECT_TRUE(frame.beamPointsHold(6.24, kPeriod));
  EXPECT_FALSE(frame.beamPointsHold(6.26, kPeriod));
}

TEST(OpenFrame, AllowanceStaysBetweenItsBoundsInResourcePeriods) {
  FrameBuilderParams params;
  params.alpha_0 = 1.0;
  params.least_allowance_periods = 2;
  params.greatest_allowance_periods = 7;
  OpenFrame slow(0, params), fast(0, params), blind(0, params);
  slow.add(at(0.0, 150e3));                    // 0.02 / (1000/150000) = 3 s
  fast.add(at(0.0, 500.0));                    // 0.02 / 2 = 0.01 s
  blind.add(spanned(dwellAt(0.0, 0.0, 0.0)));  // no r_min
  EXPECT_DOUBLE_EQ(slow.beamPointAllowance(kPeriod), 0.7);
  EXPECT_DOUBLE_EQ(fast.beamPointAllowance(kPeriod), 0.2);
  EXPECT_DOUBLE_EQ(blind.beamPointAllowance(kPeriod), 0.7);
}

TEST(OpenFrame, StrictGroupRuleRejectsAnyTrackExpectedBefore) {
  const FrameBuilderParams params;
  OpenFrame frame(0, params);
  frame.add(spanned(expecting({1, 2, 3})));
  frame.add(spanned(expecting({})));
  frame.add(spanned(expecting({3, 7})));
  EXPECT_FALSE(frame.dwellGroupTestRejects(expecting({})));
  EXPECT_FALSE(frame.dwellGroupTestRejects(expecting({4, 5, 6, 8})));
  EXPECT_TRUE(frame.dwellGroupTestRejects(expecting({4, 7})));
  EXPECT_TRUE(frame.dwellGroupTestRejects(expecting({1})));
}

// By hand: of the four tracks 1, 2, 3, 7 expected in the frame, one is a quarter and two are a half.
TEST(OpenFrame, RatioGroupRuleAllowsAFewTracksExpectedBefore) {
  FrameBuilderParams params;
  params.strict_group_rule = false;
  params.group_ratio = 0.3;
  OpenFrame frame(0, params), lenient(0, params), empty(0, params);
  frame.add(spanned(expecting({1, 2, 3})));
  frame.add(spanned(expecting({3, 7})));
  EXPECT_FALSE(frame.dwellGroupTestRejects(expecting({7, 8, 9})));
  EXPECT_TRUE(frame.dwellGroupTestRejects(expecting({1, 7})));
  EXPECT_FALSE(empty.dwellGroupTestRejects(expecting({1}))) << "nothing was expected before";
  params.group_ratio = 0.25;
  EXPECT_TRUE(frame.dwellGroupTestRejects(expecting({7, 8, 9}))) << "a quarter is not below a quarter";
}

// The letter would test (6) also for the far dwell once the near one has passed the coarse test; ours does not.
TEST(OpenFrame, FineTestCountsOnlyForDwellsThatPassTheCoarseOne) {
  const FrameBuilderParams params;
  OpenFrame frame(0, params);
  SpannedDwell beside = at(0.0, 50e3);
  beside.dwell.u = 0.012;
  frame.add(beside);          // coarse: close, fine: far enough
  frame.add(at(0.0, 150e3));  // coarse: another range, fine: the same beam
  EXPECT_FALSE(frame.beamPointTestRejects(at(0.0, 50e3)));
  frame.add(at(0.0, 50e3));
  EXPECT_TRUE(frame.beamPointTestRejects(at(0.0, 50e3)));
}

}  // namespace
}  // namespace esa_frame_builder
