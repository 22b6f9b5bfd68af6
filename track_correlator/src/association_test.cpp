#include "association.h"

#include <gtest/gtest.h>

#include <functional>

#include <tws_core/random_test_helpers.h>

namespace track_correlator {
namespace {

constexpr double kGate = 20.0;

std::vector<std::pair<std::uint32_t, std::uint32_t>> solved(Association& association,
                                                            const std::vector<GatedPair>& pairs) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> numbers;
  for (const GatedPair& pair : association.solve(pairs, 12, 12, kGate))
    numbers.emplace_back(pair.primary, pair.secondary);
  return numbers;
}

using Numbers = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

// If these fail, tracks of different aircraft become one.

TEST(Association, TakesLonePairsWithoutAnAssignment) {
  Association association;
  EXPECT_EQ(solved(association, {{3, 1, 19.0}, {0, 2, 5.0}}), (Numbers{{0, 2}, {3, 1}}));
  EXPECT_EQ(association.clusters(), 0U);
}

// Figure 9: S2 lies in the gates of P1 and P2, and nearer to P1; S1 lies in the gate of P1 only.
TEST(Association, LeavesTheSharedSecondaryToThePrimaryThatHasNoOther) {
  Association association;
  EXPECT_EQ(solved(association, {{1, 1, 6.0}, {1, 2, 4.0}, {2, 2, 7.0}}), (Numbers{{1, 1}, {2, 2}}));
  EXPECT_EQ(association.clusters(), 1U);
}

TEST(Association, GivesASecondaryInTwoGatesToTheNearerPrimary) {
  Association association;
  EXPECT_EQ(solved(association, {{0, 0, 6.0}, {1, 0, 4.0}}), (Numbers{{1, 0}}));
}

TEST(Association, HasNothingToSayOfNothing) {
  Association association;
  EXPECT_TRUE(association.solve({}, 0, 0, kGate).empty());
}

// Every way to make pairs, tried one by one; a primary without a secondary costs the gate.
TEST(Association, FindsTheLeastSumOfAllWaysToMakePairs) {
  auto generator = tws::seededGenerator();
  Association association;
  for (int round = 0; round < 300; ++round) {
    const int primaries = tws::uniformInt(generator, 1, 6), secondaries = tws::uniformInt(generator, 1, 6);
    std::vector<std::vector<double>> distance(static_cast<std::size_t>(primaries));
    std::vector<GatedPair> pairs;
    for (std::uint32_t p = 0; p < distance.size(); ++p) {
      for (std::uint32_t s = 0; s < static_cast<std::uint32_t>(secondaries); ++s) {
        distance[p].push_back(tws::uniform(generator, 0.0, 3.0 * kGate));
        if (distance[p][s] <= kGate) pairs.push_back({p, s, distance[p][s]});
      }
    }
    std::vector<bool> used(static_cast<std::size_t>(secondaries), false);
    const std::function<double(std::size_t)> least = [&](std::size_t p) {
      if (p == distance.size()) return 0.0;
      double best = kGate + least(p + 1);
      for (std::size_t s = 0; s < used.size(); ++s) {
        if (used[s] || distance[p][s] > kGate) continue;
        used[s] = true;
        best = std::min(best, distance[p][s] + least(p + 1));
        used[s] = false;
      }
      return best;
    };
    const auto& chosen = association.solve(pairs, distance.size(), used.size(), kGate);
    double sum = kGate * static_cast<double>(distance.size() - chosen.size());
    for (const GatedPair& pair : chosen) sum += pair.distance;
    ASSERT_NEAR(sum, least(0), 1e-9);
  }
}

}  // namespace
}  // namespace track_correlator
