#include "core/radar_state.h"

#include <gtest/gtest.h>

#include <tws_core/random_test_helpers.h>

namespace adit_tracker {
namespace {

RadarParams params() {
  RadarParams p;
  p.range_sigma = 100.0;
  p.azimuth_sigma = 0.005;
  return p;
}

TEST(RadarQuality, TakesThePlotsOwnSigmaWhereItHasOne) {
  const RadarQuality quality(params(), true);
  tws::Plot plot;
  EXPECT_DOUBLE_EQ(quality.rangeSigma(plot), 100.0);
  EXPECT_DOUBLE_EQ(quality.azimuthSigma(plot), 0.005);
  plot.range_sigma = 30.0;
  plot.azimuth_sigma = 0.001;
  EXPECT_DOUBLE_EQ(quality.rangeSigma(plot), 30.0);
  EXPECT_DOUBLE_EQ(quality.azimuthSigma(plot), 0.001);
}

// If this fails, a radar whose errors the user does not know keeps gates that are far too narrow or too wide.
TEST(RadarQuality, LearnsErrorsThatAreTwiceOrHalfOfWhatItWasTold) {
  auto generator = tws::seededGenerator();
  for (const double truth : {50.0, 200.0}) {
    RadarQuality quality(params(), true);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 5000; ++i) {
      const double scale = truth / 100.0;
      quality.learnErrors(normal(generator) * truth / quality.rangeSigma(),
                          normal(generator) * scale * 0.005 / quality.azimuthSigma());
    }
    // It aims at 55 % within the median, where a normal deviate has 0.756 sigma: 12 % more than the truth.
    EXPECT_NEAR(quality.rangeSigma() / truth, 0.7554 / 0.6745, 0.1);
    EXPECT_NEAR(quality.azimuthSigma() / (truth / 100.0 * 0.005), 0.7554 / 0.6745, 0.1);
  }
}

TEST(RadarQuality, KeepsWhatItWasToldWhenItMustNotLearn) {
  RadarQuality quality(params(), false);
  for (int i = 0; i < 100; ++i) quality.learnErrors(5.0, 5.0);
  EXPECT_DOUBLE_EQ(quality.rangeSigma(), 100.0);
}

// If this fails, one bad hour of a radar leaves gates that take everything or nothing.
TEST(RadarQuality, NeverLearnsBeyondItsLimits) {
  RadarQuality wide(params(), true), narrow(params(), true);
  for (int i = 0; i < 20000; ++i) {
    wide.learnErrors(100.0, 100.0);
    narrow.learnErrors(0.0, 0.0);
  }
  EXPECT_DOUBLE_EQ(wide.rangeSigma(), 500.0);
  EXPECT_DOUBLE_EQ(narrow.rangeSigma(), 10.0);
}

// If this fails, a radar that tells close aircraft apart still hides one behind the other.
TEST(RadarQuality, LearnsWhetherItTellsCloseTargetsApart) {
  RadarQuality quality(params(), true);
  EXPECT_DOUBLE_EQ(quality.merging(), 0.9);
  for (int pair = 0; pair < 100; ++pair) quality.learnMerging(pair % 5 == 0 ? 1.0 : 0.0);
  EXPECT_NEAR(quality.merging(), 0.2 + 0.7 * std::pow(0.98, 100), 0.05);
}

}  // namespace
}  // namespace adit_tracker
