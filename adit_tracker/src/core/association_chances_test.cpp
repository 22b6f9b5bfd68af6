#include "core/association_chances.h"

#include <gtest/gtest.h>

#include <tws_core/random_test_helpers.h>
#include <cmath>
#include <functional>

namespace adit_tracker {
namespace {

std::vector<Pairing> solved(std::vector<Pairing> pairings) {
  AssociationChances().solve(pairings);
  return pairings;
}

/// By going through all ways to pair tracks with plots, each of which weighs the product of its odds.
std::vector<Pairing> byEnumeration(std::vector<Pairing> pairings, std::size_t tracks) {
  double total = 0.0;
  std::vector<double> sums(pairings.size(), 0.0);
  std::vector<std::size_t> chosen;
  const std::function<void(std::size_t, double)> go = [&](std::size_t track, double weight) {
    if (track == tracks) {
      total += weight;
      for (const auto i : chosen) sums[i] += weight;
      return;
    }
    go(track + 1, weight);
    for (std::size_t i = 0; i < pairings.size(); ++i) {
      const auto isTaken = [&](std::size_t other) { return pairings[other].plot == pairings[i].plot; };
      if (pairings[i].track != track || std::any_of(chosen.begin(), chosen.end(), isTaken)) continue;
      chosen.push_back(i);
      go(track + 1, weight * pairings[i].odds);
      chosen.pop_back();
    }
  };
  go(0, 1.0);
  for (std::size_t i = 0; i < pairings.size(); ++i) pairings[i].chance = sums[i] / total;
  return pairings;
}

double greatestDifference(const std::vector<Pairing>& a, const std::vector<Pairing>& b) {
  double greatest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) greatest = std::max(greatest, std::abs(a[i].chance - b[i].chance));
  return greatest;
}

TEST(AssociationChances, OneTrackAndOnePlotAreTheirOdds) {
  EXPECT_NEAR(solved({{0, 0, 3.0}})[0].chance, 3.0 / 4.0, 1e-9);
}

// The ways: none 1, the first plot 2, the second 5.
TEST(AssociationChances, OneTrackAndTwoPlotsShareByOdds) {
  const auto p = solved({{0, 0, 2.0}, {0, 1, 5.0}});
  EXPECT_NEAR(p[0].chance, 2.0 / 8.0, 1e-6);
  EXPECT_NEAR(p[1].chance, 5.0 / 8.0, 1e-6);
}

// None 1, one's 9, the other's 4; never both. If this fails, two tracks live on one plot.
TEST(AssociationChances, TwoTracksAndOnePlotShareByOdds) {
  const auto p = solved({{0, 0, 9.0}, {1, 0, 4.0}});
  EXPECT_NEAR(p[0].chance, 9.0 / 14.0, 1e-3);
  EXPECT_NEAR(p[1].chance, 4.0 / 14.0, 1e-3);
}

// If this fails, a track is held to a plot that another one needs, though it has one of its own.
TEST(AssociationChances, ATrackGivesWayToOneThatHasNoOtherPlot) {
  const auto p = solved({{0, 0, 100.0}, {0, 1, 100.0}, {1, 0, 100.0}});
  EXPECT_GT(p[1].chance, 0.95);
  EXPECT_GT(p[2].chance, 0.95);
  EXPECT_LT(p[0].chance, 0.05);
}

TEST(AssociationChances, AreExactWhereThePairingsFormNoRing) {
  auto generator = tws::seededGenerator();
  std::uniform_real_distribution<double> exponent(-3.0, 3.0);
  for (int round = 0; round < 200; ++round) {
    // A chain: track 0, plot 0, track 1, plot 1, …, each pairing with odds from 0.001 to 1000.
    std::vector<Pairing> chain;
    for (std::size_t i = 0; i < 4; ++i) {
      chain.push_back({i, i, std::pow(10.0, exponent(generator))});
      if (i < 3) chain.push_back({i + 1, i, std::pow(10.0, exponent(generator))});
    }
    EXPECT_LT(greatestDifference(solved(chain), byEnumeration(chain, 4)), 2e-3);
  }
}

// Williams & Lau report errors of a few hundredths; ours are those of rings with odds from 0.01 to 100.
TEST(AssociationChances, AreCloseWhereTheyDo) {
  auto generator = tws::seededGenerator();
  std::uniform_real_distribution<double> exponent(-2.0, 2.0);
  double sum = 0.0;
  for (int round = 0; round < 200; ++round) {
    std::vector<Pairing> all;
    for (std::size_t track = 0; track < 3; ++track) {
      for (std::size_t plot = 0; plot < 3; ++plot) all.push_back({track, plot, std::pow(10.0, exponent(generator))});
    }
    const double difference = greatestDifference(solved(all), byEnumeration(all, 3));
    EXPECT_LT(difference, 0.3);
    sum += difference;
  }
  EXPECT_LT(sum / 200.0, 0.06);
}

// If this fails, a plot counts as more than one, or a track as more than one target.
TEST(AssociationChances, OfATrackAndOfAPlotAddUpToOneAtMost) {
  std::vector<Pairing> all;
  for (std::size_t track = 0; track < 8; ++track) {
    for (std::size_t plot = 0; plot < 5; ++plot) all.push_back({track, plot, 1e9});
  }
  std::vector<double> tracks(8, 0.0), plots(5, 0.0);
  for (const Pairing& p : solved(all)) {
    ASSERT_TRUE(std::isfinite(p.chance));
    tracks[p.track] += p.chance;
    plots[p.plot] += p.chance;
  }
  for (const double sum : tracks) EXPECT_LT(sum, 1.01);
  for (const double sum : plots) EXPECT_LT(sum, 1.01);
}

}  // namespace
}  // namespace adit_tracker
