#include "timing.h"

#include <gtest/gtest.h>

#include <cmath>

#include "epoch_test_helpers.h"

namespace track_evaluation {
namespace {

// An operator relies on these figures to know how old the picture is.

TEST(Timing, LatencyIsFromTheCrossingToThePublication) {
  Timing timing;
  for (int i = 0; i <= 10; ++i) {
    timing.addPlots("a", i, i - 0.1, 20);
    timing.addTracks("a", i + 0.02, i - 0.5, 5);
  }
  const MetricList metrics = timing.report();
  EXPECT_NEAR(valueOf(metrics, "plots_latency_p50_s"), 0.1, 1e-9);
  EXPECT_NEAR(valueOf(metrics, "tracks_latency_max_s"), 0.52, 1e-9);
  EXPECT_NEAR(valueOf(metrics, "tracks_processing_p99_s"), 0.02, 1e-9);
  EXPECT_NEAR(valueOf(metrics, "plots_per_s"), 220 / 10.02, 1e-9);
  EXPECT_NEAR(valueOf(metrics, "track_reports_per_s"), 55 / 10.02, 1e-9);
}

TEST(Timing, WithoutMessagesNothingIsKnown) {
  for (const auto& [name, value] : Timing().report()) EXPECT_TRUE(std::isnan(value)) << name;
}

}  // namespace
}  // namespace track_evaluation
