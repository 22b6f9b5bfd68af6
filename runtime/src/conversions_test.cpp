#include <tws_runtime/conversions.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <tws_core/random_test_helpers.h>

namespace tws_runtime {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

tws::Plot goodPlot() {
  tws::Plot plot;
  plot.time = 12.375;
  plot.range = 50000.0;
  plot.azimuth = 1.25;
  plot.elevation = 0.1;
  plot.range_rate = -200.0;
  plot.range_sigma = 20.0;
  plot.azimuth_sigma = 0.002;
  plot.snr = 13.5;
  return plot;
}

std::string faultWith(double tws_msgs::Detection::*field, double value) {
  tws_msgs::Detection detection = toDetection(goodPlot());
  detection.*field = value;
  return faultOf(detection);
}

// If this fails, the stamps of tracks differ from those of the sectors that made them.
TEST(Conversions, EveryNanosecondBelowTwoToTheTwentyThirdSecondsComesBack) {
  std::mt19937_64 random = tws::seededGenerator();
  std::uniform_int_distribution<std::uint32_t> second(0, (1u << 23) - 1);
  std::uniform_int_distribution<std::uint32_t> nanosecond(0, 999999999);
  for (int i = 0; i < 100000; ++i) {
    const ros::Time time(second(random), nanosecond(random));
    ASSERT_EQ(toTime(toSeconds(time)), time);
  }
  for (const ros::Time time : {ros::Time(0, 0), ros::Time(0, 1), ros::Time((1u << 23) - 1, 999999999)})
    EXPECT_EQ(toTime(toSeconds(time)), time);
}

// The spacing of doubles between 2^30 and 2^31 is 2^-22 s = 0.238 us; rounding errs by at most half of it.
TEST(Conversions, WallTimeComesBackToWithinHalfTheSpacingOfDoubles) {
  std::mt19937_64 random = tws::seededGenerator();
  std::uniform_int_distribution<std::uint32_t> nanosecond(0, 999999999);
  for (int i = 0; i < 10000; ++i) {
    const ros::Time time(1700000000u, nanosecond(random));
    ASSERT_LE(std::abs((toTime(toSeconds(time)) - time).toNSec()), 120);
  }
}

TEST(Conversions, SecondsAreTheNearestDouble) {
  EXPECT_EQ(toSeconds(ros::Time(12, 375000000)), 12.375);
  EXPECT_EQ(toSeconds(ros::Time(10, 100000000)), 10.1);
  EXPECT_EQ(toSeconds(ros::Time(1700000000u, 500000000)), 1700000000.5);
  EXPECT_EQ(toTime(0.9999999999), ros::Time(1, 0));
}

TEST(Conversions, ATimeThatRosCannotHoldIsRefused) {
  for (const double seconds : {kNaN, -1e-9, 4294967296.0, kInfinity})
    EXPECT_THROW(toTime(seconds), std::invalid_argument);
  EXPECT_EQ(toTime(4294967295.0), ros::Time(4294967295u, 0));
}

// If this fails, a tracker computes with another plot than the radar sent.
TEST(Conversions, APlotComesBackAsItWas) {
  const tws::Plot plot = goodPlot();
  const tws::Plot back = toPlot(toDetection(plot));
  EXPECT_EQ(back.time, plot.time);
  EXPECT_EQ(back.range, plot.range);
  EXPECT_EQ(back.azimuth, plot.azimuth);
  EXPECT_EQ(back.elevation, plot.elevation);
  EXPECT_EQ(back.range_rate, plot.range_rate);
  EXPECT_EQ(back.range_sigma, plot.range_sigma);
  EXPECT_EQ(back.azimuth_sigma, plot.azimuth_sigma);
  EXPECT_EQ(back.snr, plot.snr);
}

TEST(Conversions, WhatIsUnknownStaysUnknownAndIsNoFault) {
  tws::Plot plot;
  plot.range = 1.0;
  const tws_msgs::Detection detection = toDetection(plot);
  EXPECT_EQ(faultOf(detection), "");
  const tws::Plot back = toPlot(detection);
  for (const double value : {back.elevation, back.range_rate, back.range_sigma, back.azimuth_sigma, back.snr})
    EXPECT_TRUE(std::isnan(value));
}

// If this fails, one bad plot can spoil a tracker's state.
TEST(Conversions, ABadFieldIsNamedWithItsValue) {
  using D = tws_msgs::Detection;
  EXPECT_EQ(faultOf(toDetection(goodPlot())), "");
  EXPECT_EQ(faultWith(&D::range, -5.0), "range is -5");
  EXPECT_EQ(faultWith(&D::range, 0.0), "range is 0");
  EXPECT_EQ(faultWith(&D::range, kInfinity), "range is inf");
  EXPECT_EQ(faultWith(&D::range, kNaN), "range is nan");
  EXPECT_EQ(faultWith(&D::azimuth, kNaN), "azimuth is nan");
  EXPECT_EQ(faultWith(&D::azimuth, -0.5), "azimuth is -0.5");
  EXPECT_EQ(faultWith(&D::azimuth, 8.0), "azimuth is 8");
  EXPECT_NE(faultWith(&D::azimuth, 2.0 * std::acos(-1.0)), "");
  EXPECT_EQ(faultWith(&D::azimuth, 0.0), "");
  EXPECT_EQ(faultWith(&D::elevation, 2.0), "elevation is 2");
  EXPECT_EQ(faultWith(&D::range_rate, -kInfinity), "range rate is -inf");
  EXPECT_EQ(faultWith(&D::range_sigma, 0.0), "");
  EXPECT_EQ(faultWith(&D::range_sigma, -1.0), "range sigma is -1");
  EXPECT_EQ(faultWith(&D::azimuth_sigma, -0.1), "azimuth sigma is -0.1");
  tws_msgs::Detection loud = toDetection(goodPlot());
  loud.snr = std::numeric_limits<float>::infinity();
  EXPECT_EQ(faultOf(loud), "signal-to-noise ratio is inf");
}

TEST(Conversions, ASectorBecomesAMessageStampedWhenTheBeamLeft) {
  tws::RadarSector sector;
  sector.sector = 17;
  sector.running = 81;
  sector.enter_time = 7.5;
  sector.leave_time = 7.625;
  sector.plots = {goodPlot(), goodPlot()};
  const tws_msgs::Detections message = toDetections(sector, "sps12", "sps12_site");
  EXPECT_EQ(message.header.stamp, ros::Time(7, 625000000));
  EXPECT_EQ(message.header.frame_id, "sps12_site");
  EXPECT_EQ(message.radar, "sps12");
  EXPECT_EQ(message.sector, 17);
  EXPECT_EQ(message.running_sector, 81u);
  ASSERT_EQ(message.detections.size(), 2u);
  EXPECT_EQ(message.detections[1].range, 50000.0);
}

}  // namespace
}  // namespace tws_runtime
