#include "core/radars.h"

#include <gtest/gtest.h>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

// If this fails, radars that stand side by side get sectors of their own, or two sites share theirs.
TEST(Radars, ASiteIsNewOnceForAllRadarsThatStandThere) {
  Radars radars(paramsFor("default", {6.0, 8.0, 10.0}));
  const tws::SiteFrame island{40e3, 0.0, 0.01};
  radars.place(1, island);
  radars.place(2, {40e3 + 50.0, 0.0, 0.01});
  EXPECT_FALSE(radars.severalSites());
  EXPECT_TRUE(radars.join(1));
  EXPECT_FALSE(radars.join(2));
  EXPECT_EQ(radars.sites().size(), 2U);
  EXPECT_EQ(radars.at(0).site, 0U);
  EXPECT_EQ(radars.at(1).site, 1U);
  EXPECT_EQ(radars.at(2).site, 1U);
}

TEST(Radars, OneThatHasNotJoinedCountsAtTheFirstSite) {
  Radars radars(paramsFor("default", {6.0, 8.0}));
  radars.place(1, {40e3, 0.0, 0.0});
  EXPECT_EQ(radars.frames()[1].x, 0.0);
  radars.join(1);
  EXPECT_EQ(radars.frames()[1].x, 40e3);
}

// If this fails, tracks and clutter points are compared on each scan, when nothing has moved far enough.
TEST(Radars, ConversionsAreDueOnEveryEighthScan) {
  ConversionParams params;
  params.scans = 8;
  const tws::Antenna antenna(6.0);
  const auto due = [&](std::int64_t scan, long offset) {
    return leastAgeToConvert(params, antenna, scan * tws::kSectors + 3, offset);
  };
  EXPECT_EQ(due(16, 0), 0.5 * 8 * 6.0);
  EXPECT_EQ(due(17, 0), std::nullopt);
  EXPECT_EQ(due(20, 4), 0.5 * 8 * 6.0);
}

}  // namespace
}  // namespace adit_tracker
