#include "io/scan_motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include <tws_core/angles.h>

namespace adit_tracker {
namespace {

constexpr double kPeriod = 4.0;

/// Aircraft that cross north in both directions, with errors; all plots of a scan have the time of its beginning.
/// `met(scan, azimuth)`: when they were really met [scans].
template <class Met>
std::vector<tws::Plot> scansOf(const Met& met) {
  std::mt19937 random(3);
  std::normal_distribution<> error(0.0, 60.0);
  std::vector<tws::Plot> plots;
  for (int scan = 0; scan < 40; ++scan) {
    for (int target = 0; target < 10; ++target) {
      const double speed = target % 2 == 0 ? 200.0 : -200.0;
      double azimuth = 0.0, x = 0.0;
      const double y = 20e3 + 8e3 * target;
      for (int i = 0; i < 20; ++i) {
        x = speed * (kPeriod * met(scan, azimuth) - 50.0 - 6.0 * target);
        azimuth = tws::wrapTwoPi(std::atan2(x, y));
      }
      tws::Plot plot;
      plot.time = kPeriod * scan;
      plot.range = std::hypot(x, y) + error(random);
      plot.azimuth = tws::wrapTwoPi(azimuth + error(random) / plot.range);
      plots.push_back(plot);
    }
  }
  return plots;
}

// If these fail, a file's plots get times that are off by up to a scan: a kilometre of an aircraft's way.
TEST(ScanMotion, TellsABeamThatTurnedThroughTheScan) {
  EXPECT_TRUE(moveWithTheBeam(scansOf([](int scan, double azimuth) { return scan + azimuth / tws::kTwoPi; }), kPeriod));
}

TEST(ScanMotion, TellsScansOfOneInstant) {
  EXPECT_FALSE(moveWithTheBeam(scansOf([](int scan, double) { return 1.0 * scan; }), kPeriod));
}

TEST(ScanMotion, DoesNotGuessWhereNobodyCrossesNorth) {
  auto plots = scansOf([](int scan, double azimuth) { return scan + azimuth / tws::kTwoPi; });
  for (tws::Plot& plot : plots) plot.azimuth = tws::wrapTwoPi(plot.azimuth + tws::kPi);
  EXPECT_FALSE(moveWithTheBeam(plots, kPeriod));
}

}  // namespace
}  // namespace adit_tracker
