// The paper's scenario of three targets, section III.1 and table 1, fed as tracks: no radar separates plots 20 m apart.
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <random>

#include <tws_core/random_test_helpers.h>

#include "correlator_test_helpers.h"

namespace track_correlator {
namespace {

constexpr int kSeeds = 100;
constexpr double kTrackSigma = 8.0;     // [m], in x and y: the paper's
constexpr double kVelocitySigma = 5.0;  // [m/s]; the paper says nothing

using Counts = std::array<int, 3>;

/// Height of target 1, 2, 3 on the paper's figure 7 [m] and its rate [m/s]. All fly 100 m/s in x. At scan 0 they are 1
/// km, 2 km and 100 m from the radar; in scans 10 to 20 target 1 is 20 m from both others, which are 40 m apart. With
/// that, target 3 must climb faster than the 100 m/s that the paper gives it.
std::pair<double, double> climb(int target, double t) {
  const double level[] = {1980.0, 2000.0, 1960.0}, rate[] = {98.0, 0.0, 186.0};
  if (t < 10.0) return {level[target] - rate[target] * (10.0 - t), rate[target]};
  if (t <= 20.0) return {level[target], 0.0};
  return {level[target] - rate[target] * (t - 20.0), -rate[target]};
}

/// Scans of 10 to 20 in which a target's primary was correlated with another one's secondary.
Counts miscorrelations(Scheme scheme, std::uint64_t seed) {
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> error;
  CorrelatorParams params;
  params.fusion.scheme = scheme;
  CorrelatorListener c(params);
  Counts wrong = {};
  for (int scan = 0; scan <= 22; ++scan) {
    for (int target = 0; target < 3; ++target) {
      const auto [y, vy] = climb(target, c.now());
      for (const bool primary : {true, false}) {
        TrackInput track = trackInput(static_cast<std::uint32_t>(target), c.now(), 100.0 * c.now(), y, 100.0, vy,
                                      kTrackSigma, kVelocitySigma);
        for (int i = 0; i < 4; ++i) track.state(i) += error(generator) * (i < 2 ? kTrackSigma : kVelocitySigma);
        primary ? c.correlator.addPrimary(track) : c.correlator.addSecondary(track);
      }
    }
    c.turn();
    for (const CorrelatedUpdate& update : c.lastTurn())
      if (update.correlated && !update.ended && scan >= 10 && scan <= 20)
        wrong[update.primary] += update.primary != update.secondary;
  }
  return wrong;
}

// If this fails, aircraft that fly close to each other swap their codes and heights.
TEST(BelThreeTargets, MixesUpPairsByDistanceAloneAndNoneByHistory) {
  std::array<Counts, 3> sums = {};
  const Scheme schemes[] = {Scheme::kDistance, Scheme::kPlain, Scheme::kParallelCounter};
  for (std::size_t s = 0; s < 3; ++s)
    for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
      const Counts wrong = miscorrelations(schemes[s], seed);
      for (std::size_t target = 0; target < 3; ++target) sums[s][target] += wrong[target];
    }
  std::printf("miscorrelations in scans 10 to 20, mean of %d seeds (paper: distance alone 4 4 4, history 0 0 0)\n",
              kSeeds);
  const char* names[] = {"distance alone", "history", "history, parallel counter"};
  for (std::size_t s = 0; s < 3; ++s)
    std::printf("%-26s %5.2f %5.2f %5.2f\n", names[s], sums[s][0] / 100.0, sums[s][1] / 100.0, sums[s][2] / 100.0);
  for (std::size_t target = 0; target < 3; ++target) {
    EXPECT_GT(sums[0][target], 0);
    EXPECT_EQ(sums[1][target], 0);
    EXPECT_EQ(sums[2][target], 0);
  }
}

}  // namespace
}  // namespace track_correlator
