#include "beam_break.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <tws_core/angles.h>
#include <tws_core/units.h>

namespace asterix_bridge {
namespace {

constexpr double kStart = 1000.0;
const tws::SteadyBeam kOld{kStart, 0.0, tws::kTwoPi / 4.0};

// Plots along a beam, ten a second with noise, a share of them false, until the break is found.
struct Search {
  std::mt19937 random{7};
  BeamBreak watch;
  std::optional<tws::SteadyBeam> found;
  double time = kStart;

  void play(const tws::SteadyBeam& beam, double duration, double nominal = 0.0, double false_share = 0.1) {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::normal_distribution<double> noise(0.0, tws::radians(0.3));
    for (const double end = time + duration; time < end && !found; time += 0.2 * share(random)) {
      const bool is_false = share(random) < false_share;
      const double azimuth = is_false ? tws::kTwoPi * share(random) : beam.azimuthAt(time) + noise(random);
      watch.add({time, tws::wrapTwoPi(azimuth)}, kOld);
      if (watch.since()) found = watch.find(kOld, nominal);
    }
  }
};

TEST(BeamBreak, IsNotSeenInFalsePlots) {
  Search search;
  search.play(kOld, 600.0, 0.0, 0.3);
  EXPECT_FALSE(search.found);
}

// If this fails, tracks end and begin anew when an antenna changes its speed.
TEST(BeamBreak, FindsAnotherSpeedWithinTwoTurns) {
  for (const double period : {5.0, 3.2, 2.0, 10.0}) {
    Search search;
    search.play(kOld, 40.0);
    const double start = search.time;
    const tws::SteadyBeam beam{start, kOld.azimuthAt(start), tws::kTwoPi / period};
    search.play(beam, 2.0 * std::max(period, 4.0) + 1.0);
    ASSERT_TRUE(search.found) << period;
    EXPECT_NEAR(tws::kTwoPi / search.found->rate, period, 0.03 * period);
    EXPECT_LT(std::abs(tws::angularDifference(search.found->azimuthAt(search.time), beam.azimuthAt(search.time))),
              tws::radians(3.0));
  }
}

TEST(BeamBreak, FindsTheSameSpeedAtAnotherPhase) {
  for (const double jump_deg : {15.0, 90.0, 180.0, -60.0}) {
    Search search;
    search.play(kOld, 40.0);
    const tws::SteadyBeam beam{kStart, tws::radians(jump_deg), kOld.rate};
    const double start = search.time;
    search.play(beam, 9.0);
    ASSERT_TRUE(search.found) << jump_deg;
    EXPECT_LT(search.time - start, 6.5);
    EXPECT_NEAR(search.found->rate, kOld.rate, 0.02 * kOld.rate);
    EXPECT_LT(std::abs(tws::angularDifference(search.found->azimuthAt(search.time), beam.azimuthAt(search.time))),
              tws::radians(2.0));
  }
}

TEST(BeamBreak, FindsNothingInPlotsAnywhere) {
  Search search;
  search.play(kOld, 40.0);
  search.play(kOld, 60.0, 0.0, 1.0);
  EXPECT_FALSE(search.found);
}

}  // namespace
}  // namespace asterix_bridge
