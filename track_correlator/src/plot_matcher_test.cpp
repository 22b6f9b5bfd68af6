#include "plot_matcher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include <tws_core/geometry.h>
#include <tws_core/random_test_helpers.h>

namespace track_correlator {
namespace {

const SecondaryParams kParams;

SecondaryPlot plotAt(double range, double azimuth, std::uint16_t code = kNoCode) {
  SecondaryPlot plot;
  plot.time = 8.0;
  plot.range = range;
  plot.azimuth = azimuth;
  plot.mode_3a.code = code;
  return plot;
}

SecondaryTrack trackAt(double range, double azimuth, std::uint16_t code = kNoCode) {
  SecondaryTrack track;
  track.firm = true;
  track.state.mean.head<2>() = tws::planarFromPolar(range, azimuth);
  track.state.covariance.diagonal() << 1e4, 1e4, 100.0, 100.0;
  track.mode_3a.take({code, false}, 3);
  return track;
}

std::vector<int> matched(const std::vector<SecondaryTrack>& tracks, const std::vector<SecondaryPlot>& plots) {
  std::vector<const SecondaryTrack*> pointers;
  for (const auto& track : tracks) pointers.push_back(&track);
  std::vector<PlacedPlot> placed;
  for (const auto& plot : plots) placed.push_back(place(plot, kParams));
  return PlotMatcher(kParams).match(pointers, placed);
}

// If these fail, plots go to the wrong aircraft.

TEST(PlotMatcher, GoesByUniqueCodeEvenWhenAnotherPlotIsNearer) {
  EXPECT_EQ(matched({trackAt(50e3, 1.0, 01234)}, {plotAt(50e3, 1.0, 05555), plotAt(51e3, 1.0, 01234)}),
            (std::vector<int>{1}));
}

TEST(PlotMatcher, GoesByPositionWhereTwoHaveTheCode) {
  EXPECT_EQ(matched({trackAt(50e3, 1.0, 01200), trackAt(50.4e3, 1.0, 01200)},
                    {plotAt(50.45e3, 1.0, 01200), plotAt(50.05e3, 1.0, 01200)}),
            (std::vector<int>{1, 0}));
}

TEST(PlotMatcher, TakesNoCodeBeyondTheCodeGate) {
  EXPECT_EQ(matched({trackAt(50e3, 1.0, 01234)}, {plotAt(55.1e3, 1.0, 01234)}), (std::vector<int>{PlotMatcher::kNone}));
}

TEST(PlotMatcher, TakesNoPlotOfAnotherAddress) {
  SecondaryTrack track = trackAt(50e3, 1.0);
  track.aircraft_address = 0xABCDEF;
  SecondaryPlot plot = plotAt(50e3, 1.0);
  plot.aircraft_address = 0xABCDE0;
  EXPECT_EQ(matched({track}, {plot}), (std::vector<int>{PlotMatcher::kNone}));
  plot.aircraft_address = 0xABCDEF;
  EXPECT_EQ(matched({track}, {plot}), (std::vector<int>{0}));
}

// The least sum over all ways to give plots to tracks, tried one by one.
TEST(PlotMatcher, FindsTheLeastSumOfAllAssignmentsByPosition) {
  auto generator = tws::seededGenerator();
  for (int round = 0; round < 200; ++round) {
    const int n = tws::uniformInt(generator, 1, 5);
    std::vector<SecondaryTrack> tracks;
    std::vector<SecondaryPlot> plots;
    for (int i = 0; i < n; ++i) {
      tracks.push_back(trackAt(tws::uniform(generator, 50e3, 50.2e3), 1.0));
      plots.push_back(plotAt(tws::uniform(generator, 50e3, 50.2e3), 1.0));
    }
    const auto cost = [&](const std::vector<int>& order) {
      double sum = 0.0;
      for (std::size_t i = 0; i < order.size(); ++i) {
        const PlacedPlot p = place(plots[static_cast<std::size_t>(order[i])], kParams);
        sum += tws::innovation(predicted(tracks[i], 8.0, kParams), p.measured).nis;
      }
      return sum;
    };
    std::vector<int> order(static_cast<std::size_t>(n));
    std::iota(order.begin(), order.end(), 0);
    double least = cost(order);
    while (std::next_permutation(order.begin(), order.end())) least = std::min(least, cost(order));
    EXPECT_NEAR(cost(matched(tracks, plots)), least, 1e-9);
  }
}

}  // namespace
}  // namespace track_correlator
