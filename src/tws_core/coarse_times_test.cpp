#include <tws_core/coarse_times.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>

namespace tws {
namespace {

double beamAt(double time, double period) { return wrapTwoPi(1.0 + kTwoPi * time / period); }

// Four a second for two minutes, in order of time.
TimedAzimuths plotsAt(double period) {
  auto generator = seededGenerator();
  TimedAzimuths plots;
  for (int i = 0; i < 480; ++i) plots.push_back({uniform(generator, 0.0, 120.0), 0.0});
  std::sort(plots.begin(), plots.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  for (TimedAzimuth& plot : plots) plot.azimuth = beamAt(plot.time, period);
  return plots;
}

TimedAzimuths cutOff(TimedAzimuths plots, double step) {
  for (TimedAzimuth& plot : plots) plot.time = std::floor(plot.time / step) * step;
  return plots;
}

TEST(CoarseTimes, TheirStepIsSeen) {
  const TimedAzimuths plots = plotsAt(4.0);
  EXPECT_EQ(commonStep(plots), 0.0);
  for (const double step : {0.1, 0.5, 1.0, 2.0}) EXPECT_NEAR(commonStep(cutOff(plots, step)), step, 1e-9);
  EXPECT_EQ(commonStep(cutOff(plots, 1.0 / 128.0)), 0.0);
  TimedAzimuths one_off = cutOff(plots, 1.0);
  one_off[100].time += 0.3;
  EXPECT_EQ(commonStep(one_off), 0.0);
  EXPECT_EQ(commonStep({plots.begin(), plots.begin() + 19}), 0.0);
}

// If this fails, a file whose times are whole seconds has hundreds of tracks, and hardly one that lasts.
TEST(CoarseTimes, BecomeThoseAtWhichTheBeamWasThere) {
  for (const double period : {2.5, 4.0, 4.008, 10.0}) {
    const TimedAzimuths plots = plotsAt(period);
    for (const double given : {0.0, 0.5}) {  // cut off against the beam as it is, and against a beam drawn to the times
      const Rotation rotation = Rotation::uniform(period, 1.0 + kTwoPi * given / period);
      const std::vector<double> times = refinedTimes(cutOff(plots, 1.0), rotation, 1.0);
      for (std::size_t i = 0; i < plots.size(); ++i) ASSERT_NEAR(times[i], plots[i].time - given, 1e-6) << period;
    }
  }
}

// A false plot must not get a time at which the radar never looked there.
TEST(CoarseTimes, OfAPlotOffTheBeamStayNearWhereTheyWere) {
  TimedAzimuths plots = cutOff(plotsAt(8.0), 1.0);
  plots[100].azimuth = wrapTwoPi(plots[100].azimuth + kPi);
  EXPECT_NEAR(refinedTimes(plots, Rotation::uniform(8.0, 1.0), 1.0)[100], plots[100].time + 0.5, 0.1);
}

// If this fails, the files of trackers that think in scans are refused.
TEST(CoarseTimes, OnePerRevolutionIsAWholeScan) {
  for (const double period : {2.5, 4.008, 12.0}) {
    const auto rotation = rotationOfWholeScans(cutOff(plotsAt(period), period));
    ASSERT_TRUE(rotation) << period;
    EXPECT_NEAR(rotation->period(), period, 1e-6);
    EXPECT_NEAR(std::remainder(rotation->unwrappedAt(5.0 * period), kTwoPi), 0.0, 1e-6);
  }
  EXPECT_FALSE(rotationOfWholeScans(plotsAt(4.0)));
  EXPECT_FALSE(rotationOfWholeScans(cutOff(plotsAt(4.0), 1.0)));
  EXPECT_FALSE(rotationOfWholeScans(cutOff(plotsAt(4.0), 2.0)));  // half a revolution
  EXPECT_FALSE(rotationOfWholeScans(cutOff(plotsAt(3.0), 2.0)));
}

}  // namespace
}  // namespace tws
