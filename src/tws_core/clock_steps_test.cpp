#include <tws_core/clock_steps.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>
#include <tws_core/units.h>

namespace tws {
namespace {

struct Recording {
  TimedAzimuths plots;  // in order of their times
  std::vector<double> true_times;
};

// Five plots a second for five minutes; at `at` the clock is put forward, or the beam is elsewhere [s, s, rad].
Recording recordingOf(double at, double step, double jump, double pause = 0.0) {
  auto generator = seededGenerator();
  std::vector<std::pair<TimedAzimuth, double>> all;
  for (int i = 0; i < 1500; ++i) {
    const double time = uniform(generator, 0.0, 300.0);
    if (time > at && time < at + pause) continue;
    const double azimuth = kTwoPi * time / 4.0 + (time > at ? jump : 0.0) + uniform(generator, -0.005, 0.005);
    all.push_back({{time > at ? time + step : time, wrapTwoPi(azimuth)}, time});
  }
  std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first.time < b.first.time; });
  Recording recording;
  for (const auto& [plot, time] : all) {
    recording.plots.push_back(plot);
    recording.true_times.push_back(time);
  }
  return recording;
}

// If this fails, all tracks end when a radar's clock is set, or take plots 3 s off for a manoeuvre.
TEST(ClockSteps, AreToldByTheBeamAndUndone) {
  for (const double step : {0.5, -0.5, 1.5, -1.5, 3.0, -3.0, 5.0, -5.0, 7.0, -7.0})
    for (const double at : {100.0, 200.0}) {
      const Recording recording = recordingOf(at, step, 0.0);
      const ClockSteps found = findClockSteps(recording.plots, Rotation::fromPlots(recording.plots));
      ASSERT_EQ(found.steps.size(), 1U) << step;
      EXPECT_NEAR(found.steps[0].step, step, 0.02);
      // By chance nothing may have been seen for seconds before it.
      double last = 0.0;
      for (const double time : recording.true_times) last = std::max(last, time <= at ? time : 0.0);
      EXPECT_NEAR(found.steps[0].time, last, 1.0);
      const double kept = at == 200.0 ? 0.0 : step;  // the longer part's times stay
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < recording.plots.size(); ++i)
        wrong += std::abs(recording.plots[i].time + found.corrections[i] - recording.true_times[i] - kept) > 0.03;
      EXPECT_LE(wrong, 2U) << step;
    }
}

// If this fails, the tracks of a radar that was restarted are told a time that is not theirs.
TEST(ClockSteps, AreNoRestartsNorOtherSpeeds) {
  const Recording restarted = recordingOf(150.0, 0.0, 1.5, 20.0);
  const ClockSteps found = findClockSteps(restarted.plots, Rotation::fromPlots(restarted.plots));
  EXPECT_TRUE(found.steps.empty());
  EXPECT_EQ(*std::max_element(found.corrections.begin(), found.corrections.end()), 0.0);
  Recording slower = recordingOf(150.0, 0.0, 0.0);
  for (TimedAzimuth& plot : slower.plots)
    if (plot.time > 150.0) plot.azimuth = wrapTwoPi(kTwoPi * (37.5 + (plot.time - 150.0) / 5.0));
  const Rotation rotation = Rotation::fromPlots(slower.plots);
  ASSERT_EQ(rotation.breaks().size(), 1U);
  EXPECT_TRUE(findClockSteps(slower.plots, rotation).steps.empty());
}

}  // namespace
}  // namespace tws
