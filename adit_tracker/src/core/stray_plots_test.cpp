#include "core/stray_plots.h"

#include <gtest/gtest.h>

namespace adit_tracker {
namespace {

/// A firm track at 100 km with errors of 20 m × 60 m, no detection where it was expected, and one elsewhere.
class StrayPlotsTest : public testing::Test {
 protected:
  StrayPlotsTest() {
    track_.firm = true;
    track_.predicted.range = 100e3;
    track_.predicted.azimuth = 1.0;
    track_.predicted.innovation = {400.0, 0.0, 3600.0};
    radar_.quality.falsePlotMap().addRange(350e3);
  }
  /// How fresh a detection is, so far beyond and beside the track [m].
  double freshAt(double along, double across) {
    tws::RadarSector sector;
    sector.running = 10;
    tws::Plot plot;
    plot.range = 100e3 + along;
    plot.azimuth = 1.0 + across / 100e3;
    sector.plots.push_back(plot);
    radar_.detections.add(sector);
    suspectStrays(track_, radar_, 10);
    return radar_.detections.at(10).detections[0].fresh;
  }

  Track track_;
  RadarState radar_{RadarParams{}, false};
};

// 6 and 3 standard deviations off: 0.01 / (2π · 9 · 1200) · exp(-45 / 18) = 1.2e-8 per m² against 5 false plots in 350
// km, 1.3e-11. If this fails, a gross error of a precise radar ends an aircraft's track and begins another.
TEST_F(StrayPlotsTest, APlotBesideATrackThatWasMissedIsHardlyANewTargets) {
  const double others = 5.0 / (3.14159265 * 350e3 * 350e3),
               stray = 0.01 / (2.0 * 3.14159265 * 9.0 * 1200.0) * std::exp(-2.5);
  EXPECT_NEAR(freshAt(120.0, 180.0), others / (others + stray), 1e-5);
}

TEST_F(StrayPlotsTest, APlotFarFromItIs) {
  EXPECT_DOUBLE_EQ(freshAt(300.0, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(freshAt(0.0, 800.0), 1.0);
}

// If this fails, tentative tracks on false plots keep new aircraft from being tracked.
TEST_F(StrayPlotsTest, ATentativeTrackHasNoStrays) {
  track_.firm = false;
  EXPECT_DOUBLE_EQ(freshAt(60.0, 0.0), 1.0);
}

}  // namespace
}  // namespace adit_tracker
