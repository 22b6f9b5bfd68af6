#include "core/radars.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <stdexcept>

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

/// Why counts of radar r0 that were changed so cannot be loaded.
std::string complaintAbout(const std::function<void(RadarCounts&)>& change) {
  Radars radars(paramsFor("default", {6.0, 8.0}));
  RadarCounts good, counts;
  good.radar = counts.radar = "r0";
  good.false_plots.at(3, 4) = {50.0F, 1.0F};
  change(counts);
  try {
    radars.load({good, counts});
  } catch (const std::invalid_argument& error) {
    EXPECT_DOUBLE_EQ(radars.quality(0).falsePlotMap().perScan(), 5.0) << "half of it was loaded";
    return error.what();
  }
  return "";
}

// Of a recording, say. If this fails, what is wrong spreads through the tracker.
TEST(Radars, CountsThatMakeNoSenseAreRefusedInWordsAndNothingIsLoaded) {
  const std::string of = "what was learned of radar r0: ";
  EXPECT_EQ(complaintAbout([](RadarCounts&) {}), "");
  EXPECT_EQ(complaintAbout([](RadarCounts& c) { c.radar = "r7"; }), "there is no radar 'r7'");
  EXPECT_EQ(complaintAbout([](RadarCounts& c) { c.cover.cells.clear(); }), of + "0 cells in place of 4160");
  EXPECT_EQ(complaintAbout([](RadarCounts& c) {
              c.cover.at(1, 1) = {NAN, 1.0F};
            }),
            of + "seen is not in [0, looks]: nan");
  EXPECT_EQ(complaintAbout([](RadarCounts& c) {
              c.false_plots.at(1, 1) = {1.0F, INFINITY};
            }),
            of + "scans is not in [0, 100]: inf");
  EXPECT_EQ(complaintAbout([](RadarCounts& c) { c.cover.depth = NAN; }),
            of + "depth_m is not 156.25 times 1, 2, 4, ... 1024: nan");
  EXPECT_EQ(complaintAbout([](RadarCounts& c) { c.greatest_range = NAN; }),
            of + "greatest_range_m is not in [10000, 64 depth_m]: nan");
}

}  // namespace
}  // namespace adit_tracker
