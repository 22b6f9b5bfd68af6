#include "identity.h"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "epoch_test_helpers.h"
#include "identity_csv.h"

namespace track_evaluation {
namespace {

// If one of these fails, recorded radar data without truth say something wrong about a tracker.

IdentityParams small() {
  IdentityParams params;
  params.least_plots = 3;
  params.long_gap = 10.0;
  params.monitors = {0777};
  return params;
}

/// Identity 1 has a plot every 4 s at x = 0, identity 2 one at x = 50 km at the same times.
class TwoAircraft {
 public:
  TwoAircraft() {
    for (int scan = 0; scan < 10; ++scan) {
      metrics.addPlot(4.0 * scan, 1, {0, 0});
      metrics.addPlot(4.0 * scan, 2, {50e3, 0});
    }
  }
  void update(int scan, std::uint32_t track, double x) { metrics.addUpdate(4.0 * scan, track, {x, 10.0}); }
  double metric(const std::string& name) const { return valueOf(metrics.report(), name); }
  IdentityMetrics metrics{small()};
};

TEST(Identity, OneTrackForEachIsPerfect) {
  TwoAircraft scene;
  for (int scan = 0; scan < 10; ++scan) {
    scene.update(scan, 7, 0);
    scene.update(scan, 8, 50e3);
  }
  EXPECT_EQ(scene.metric("identities"), 2.0);
  for (const char* name : {"update_probability", "purity", "continuity", "fragmentation"})
    EXPECT_EQ(scene.metric(name), 1.0) << name;
  EXPECT_EQ(scene.metric("long_gap_share"), 0.0);
  EXPECT_EQ(scene.metric("longest_gap_s"), 4.0);
}

TEST(Identity, ATrackThatChangesTheAircraftIsImpure) {
  TwoAircraft scene;
  for (int scan = 0; scan < 6; ++scan) scene.update(scan, 7, 0);
  for (int scan = 6; scan < 10; ++scan) scene.update(scan, 7, 50e3);
  EXPECT_NEAR(scene.metric("purity"), 0.6, 1e-12);
  EXPECT_NEAR(scene.metric("update_probability"), 0.5, 1e-12);
  EXPECT_NEAR(scene.metric("continuity"), 0.5, 1e-12);  // 6 of 10 and 4 of 10 plots
}

TEST(Identity, TwoTracksOneAfterTheOtherAreFragments) {
  TwoAircraft scene;
  for (int scan = 0; scan < 10; ++scan) scene.update(scan, 8, 50e3);
  for (int scan = 0; scan < 3; ++scan) scene.update(scan, 7, 0);
  for (int scan = 6; scan < 10; ++scan) scene.update(scan, 9, 0);
  EXPECT_NEAR(scene.metric("fragmentation"), 1.5, 1e-12);
  EXPECT_EQ(scene.metric("longest_gap_s"), 16.0);
  EXPECT_NEAR(scene.metric("long_gap_share"), 1.0 / (9.0 + 6.0), 1e-12);
}

TEST(Identity, MonitorsAndRareCodesDoNotCountButTracksOfMonitorsAreReported) {
  TwoAircraft scene;
  for (int scan = 0; scan < 5; ++scan) scene.metrics.addPlot(4.0 * scan, 0777, {-50e3, 0});
  scene.metrics.addPlot(4.0, 3, {90e3, 0});
  scene.update(2, 5, -50e3);
  EXPECT_EQ(scene.metric("identities"), 2.0);
  EXPECT_EQ(scene.metric("monitor_updates"), 1.0);
}

TEST(Identity, AnUpdateWithoutAPlotOfItsInstantBelongsToNobody) {
  TwoAircraft scene;
  scene.metrics.addUpdate(2.0, 7, {0, 0});
  scene.metrics.addUpdate(4.0, 7, {20e3, 0});
  EXPECT_EQ(scene.metric("update_probability"), 0.0);
}

TEST(Identity, RefusesWhatIsNoNumber) {
  IdentityMetrics metrics;
  EXPECT_THROW(metrics.addPlot(std::nan(""), 1, {0, 0}), std::invalid_argument);
  EXPECT_THROW(metrics.addUpdate(0.0, 1, {0, std::nan("")}), std::invalid_argument);
}

// If this fails, an evaluation for a day needs more and more memory, or says something else than a short one.
TEST(Identity, WhatIsSettledOnTheWayCountsTheSame) {
  IdentityMetrics all(small()), settled(small());
  for (int scan = 0; scan < 200; ++scan) {
    const double time = 4.0 * scan;
    for (IdentityMetrics* metrics : {&all, &settled}) {
      for (const std::uint32_t who : {1u, 2u, 0777u}) metrics->addPlot(time, who, {10e3 * who, 0.0});
      if (scan % 7 != 0) metrics->addUpdate(time - 4.0, scan < 150 ? 5 : 6, {10e3, 100.0});
      metrics->addUpdate(time, 8, {20e3, 100.0});
    }
    settled.settle(time - 10.0);
  }
  EXPECT_FALSE(settled.empty());
  EXPECT_EQ(all.report(), settled.report());
}

TEST(Identity, ReadsPlotsFromAFileByTheNamesOfItsColumns) {
  IdentityMetrics metrics(small());
  std::istringstream file(
      "mode3a,t_s,radar,range_m,az_deg\n1234,0,a,1000,90\n1234,4,a,1000,90\n,4,a,1,1\n1234,8,a,1000,90\n");
  readPlots(file, "p.csv", metrics);
  metrics.addUpdate(4.0, 7, {1000.0, 0.0});
  EXPECT_EQ(valueOf(metrics.report(), "identified_plots"), 3.0);
  EXPECT_NEAR(valueOf(metrics.report(), "update_probability"), 1.0 / 3.0, 1e-12);
  std::istringstream bad("mode3a,t_s,range_m,az_deg\n1289,0,1000,90\n"), poor("t_s,range_m,az_deg\n");
  EXPECT_THROW(readPlots(bad, "p.csv", metrics), std::runtime_error);
  EXPECT_THROW(readPlots(poor, "p.csv", metrics), std::runtime_error);
}

}  // namespace
}  // namespace track_evaluation
