#include <tws_core/beam_sense.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>
#include <tws_core/units.h>

namespace tws {
namespace {

using Turning = std::function<double(double)>;  // azimuth [rad] at a time [s]

// Three a second for five minutes; a share of them anywhere.
TimedAzimuths plotsOf(const Turning& beam, double odd_share = 0.0) {
  auto generator = seededGenerator();
  TimedAzimuths plots;
  for (int i = 0; i < 900; ++i) {
    const double time = uniform(generator, 0.0, 300.0);
    const bool odd = uniform(generator, 0.0, 1.0) < odd_share;
    plots.push_back(
        {time, wrapTwoPi(odd ? uniform(generator, 0.0, kTwoPi) : beam(time) + uniform(generator, -0.005, 0.005))});
  }
  return plots;
}

Turning toAndFro(double width, double sweep) {
  return [=](double time) { return 5.0 + std::abs(std::remainder(time, 2.0 * sweep)) / sweep * width; };
}

// If this fails, a radar that scans a sector is read as one that turns, and its tracks are of nothing.
TEST(BeamSense, ToAndFroIsSeenInSectorsOfAnyWidth) {
  for (const double width : {45.0, 90.0, 180.0, 270.0, 340.0})
    for (const double sweep : {2.0, 4.5, 12.0})
      EXPECT_TRUE(scansToAndFro(plotsOf(toAndFro(radians(width), sweep)))) << width << " degrees in " << sweep << " s";
  EXPECT_TRUE(scansToAndFro(plotsOf(toAndFro(radians(90.0), 4.5), 0.1)));
  EXPECT_EQ(otherScanOf(plotsOf(toAndFro(radians(90.0), 3.0))),
            "the antenna scans to and fro, at about 30 deg/s: that is not read");
}

// If this fails, a radar that works well is refused.
TEST(BeamSense, AnAntennaThatTurnsDoesNotScanToAndFro) {
  for (const double period : {0.5, 1.0, 2.5, 4.0, 12.0, 60.0})
    for (const double odd_share : {0.0, 0.1, 0.3, 1.0}) {
      const Turning beam = [=](double time) { return kTwoPi * time / period; };
      auto plots = plotsOf(beam, odd_share);
      EXPECT_FALSE(scansToAndFro(plots)) << period << " s, " << odd_share;
      for (TimedAzimuth& plot : plots) plot.time = std::floor(plot.time);
      EXPECT_FALSE(scansToAndFro(plots)) << period << " s, " << odd_share << ", whole seconds";
    }
}

TEST(BeamSense, SaysThatAnAntennaTurnsCounterClockwise) {
  EXPECT_EQ(otherScanOf(plotsOf([](double time) { return -kTwoPi * time / 4.0; })),
            "the antenna turns counter-clockwise, once in 4.000 s: that is not read");
  EXPECT_EQ(otherScanOf(plotsOf([](double) { return 0.0; }, 1.0)), "");
}

}  // namespace
}  // namespace tws
