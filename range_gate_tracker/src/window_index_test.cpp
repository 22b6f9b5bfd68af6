// What is found by an index is what a look at everything finds.
#include "window_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include <tws_core/angles.h>
#include <tws_core/random_test_helpers.h>

#include "held_plots.h"
#include "window_tracker.h"

namespace range_gate_tracker {
namespace {

/// Anywhere, many of them across north or so large that they are kept apart.
TrackWindow someWindow(std::mt19937_64& random) {
  TrackWindow window;
  window.range = tws::uniform(random, 0.0, 600e3);
  window.azimuth = tws::uniform(random, 0.0, tws::kTwoPi);
  window.half_range = tws::uniform(random, 0.0, 1.0) < 0.1 ? 1e6 : tws::uniform(random, 100.0, 10e3);
  window.half_azimuth = tws::uniform(random, 0.001, tws::kPi / 2.0);
  window.open = tws::uniformInt(random, 0, 3);
  window.close = window.open + tws::uniformInt(random, 0, 3);
  return window;
}

tws::Plot somePlot(std::mt19937_64& random) {
  tws::Plot plot;
  plot.range = tws::uniform(random, 1.0, 700e3);
  plot.azimuth = tws::uniform(random, -10.0, 10.0);
  return plot;
}

// If these fail, a track misses its detection, or a detection in its window starts another track.
TEST(WindowIndex, FindsEachTrackWithAPlotInItsWindow) {
  std::mt19937_64 random = tws::seededGenerator();
  std::vector<TrackFile> tracks(300);
  WindowIndex index;
  for (TrackFile& track : tracks) {
    track.window = someWindow(random);
    index.add(track, track.window);
  }
  for (std::size_t gone = 0; gone < 100; ++gone) index.remove(tracks[gone], tracks[gone].window);
  for (int i = 0; i < 2000; ++i) {
    const tws::Plot plot = somePlot(random);
    std::vector<const TrackFile*> found, expected;
    (void)index.any(plot, [&](const TrackFile& track) {
      if (track.window.contains(plot)) found.push_back(&track);
      return false;
    });
    for (std::size_t n = 100; n < tracks.size(); ++n)
      if (tracks[n].window.contains(plot)) expected.push_back(&tracks[n]);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, expected);
  }
}

TEST(HeldPlots, FindsThePlotsInAWindowAsTheyCame) {
  std::mt19937_64 random = tws::seededGenerator();
  HeldPlots held;
  for (int running = 0; running < 6; ++running) {
    std::vector<tws::Plot> plots(200);
    std::generate(plots.begin(), plots.end(), [&] { return somePlot(random); });
    held.add(running, plots);
  }
  held.forgetBefore(1);
  for (int i = 0; i < 300; ++i) {
    const TrackWindow window = someWindow(random);
    std::vector<HeldPlot*> expected;
    for (HeldPlots::Sector& sector : held.sectors())
      for (HeldPlot& plot : sector.plots)
        if (window.isOpenIn(plot.running) && window.contains(plot.plot)) expected.push_back(&plot);
    EXPECT_EQ(held.in(window), expected);
  }
}

}  // namespace
}  // namespace range_gate_tracker
