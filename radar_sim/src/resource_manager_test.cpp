#include "resource_manager.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace radar_sim {
namespace {

/// Ten dwells a period of 0.1 s, two of them for search at least; beams of 0.04 by 0.04.
ArrayParams squareArray() {
  ArrayParams params;
  params.name = "esa";
  params.beamwidth_u = params.beamwidth_v = 0.04;
  params.resource_period = 0.1;
  params.dwell_time = 0.01;
  params.search_share = 0.2;
  params.sequence_spacing = 0.7;
  params.sequence_distance = 1.0;
  return params;
}

SteerableTrack track(std::uint32_t number, double u, double v = 0.0) { return {number, {u, v}, 0.0, 0, 1.0}; }

std::vector<PlannedDwell> trackDwells(const std::vector<PlannedDwell>& dwells) {
  std::vector<PlannedDwell> chosen;
  std::copy_if(dwells.begin(), dwells.end(), std::back_inserter(chosen),
               [](const auto& d) { return d.is_track_dwell; });
  return chosen;
}

// "Searches on when none answers": a radar without tracker is a search radar.
TEST(ResourceManager, WithoutTracksAllGoesToSearch) {
  ResourceManager manager(squareArray());
  SearchRaster raster(squareArray());
  for (int period = 0; period < 20; ++period) {
    const auto dwells = manager.plan(0.1 * period, {});
    ASSERT_EQ(dwells.size(), 10u);
    for (const PlannedDwell& dwell : dwells) {
      const BeamPoint expected = raster.next();
      EXPECT_FALSE(dwell.is_track_dwell);
      EXPECT_EQ(dwell.beam.u, expected.u);
      EXPECT_EQ(dwell.beam.v, expected.v);
    }
  }
}

// Period by period of 0.1 s from time 10 on, last update at 9.5, revisit 0.5 s: at once, then every fifth period.
TEST(ResourceManager, VisitsATrackAsOftenAsItsRevisitTimeSays) {
  ResourceManager manager(squareArray());
  SteerableTrack one = track(7, 0.1);
  one.revisit = 0.5;
  one.last_update = 9.5;
  std::vector<int> visits;
  for (int period = 0; period < 16; ++period) {
    const auto dwells = trackDwells(manager.plan(10.0 + 0.1 * period, {one}));
    if (dwells.empty()) continue;
    visits.push_back(period);
    ASSERT_EQ(dwells.size(), 1u);
    EXPECT_EQ(dwells[0].beam.u, 0.1);
    EXPECT_EQ(dwells[0].expected, std::vector<std::uint32_t>{7});
    EXPECT_EQ(dwells[0].group, PlannedDwell::kNoGroup);
  }
  // From a dwell in the period at 10.0 the next is due at 10.5, which does not lie before the end of the period 10.4.
  EXPECT_EQ(visits, (std::vector<int>{0, 5, 10, 15}));
}

// Nine objects along two beamwidths: spacing 0.7 needs three beams, 2/3 of a beamwidth apart.
TEST(ResourceManager, CoversCloselySpacedTracksByOneSequenceOfOverlappingBeams) {
  ResourceManager manager(squareArray());
  std::vector<SteerableTrack> tracks;
  for (std::uint32_t i = 0; i < 9; ++i) tracks.push_back(track(i, 0.01 * i));
  const auto dwells = trackDwells(manager.plan(100.0, tracks));
  ASSERT_EQ(dwells.size(), 3u);
  const double u[] = {0.08 / 6, 0.04, 0.08 * 5 / 6};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(dwells[i].beam.u, u[i], 1e-12);
    EXPECT_EQ(dwells[i].group, dwells[0].group);
    EXPECT_NE(dwells[i].group, PlannedDwell::kNoGroup);
    EXPECT_EQ(dwells[i].group_dwells, 3u);
  }
  // Half-power contours reach 0.02 to either side.
  EXPECT_EQ(dwells[0].expected, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  EXPECT_EQ(dwells[1].expected, (std::vector<std::uint32_t>{2, 3, 4, 5, 6}));
  EXPECT_EQ(dwells[2].expected, (std::vector<std::uint32_t>{5, 6, 7, 8}));
}

// All members of a group that is visited start their revisit time anew, also those that were not due themselves.
TEST(ResourceManager, VisitsAGroupTogether) {
  ResourceManager manager(squareArray());
  std::vector<SteerableTrack> tracks{track(1, 0.0), track(2, 0.03), track(3, 0.2)};
  tracks[0].revisit = 0.5;
  tracks[1].revisit = tracks[2].revisit = 100.0;
  tracks[0].last_update = 9.5;
  tracks[1].last_update = tracks[2].last_update = 9.9;
  const auto dwells = trackDwells(manager.plan(10.0, tracks));
  ASSERT_EQ(dwells.size(), 2u);
  EXPECT_EQ(dwells[0].beam.v, 0.0);
  EXPECT_LT(dwells[1].beam.u, 0.04);
}

TEST(ResourceManager, HigherPriorityGoesFirstThenWhoHasWaitedLonger) {
  ResourceManager manager(squareArray());
  std::vector<SteerableTrack> tracks{track(1, 0.0), track(2, 0.2), track(3, 0.4)};
  tracks[0].last_update = 5.0;
  tracks[1].last_update = 4.0;
  tracks[2].last_update = 6.0;
  tracks[2].priority = 1;
  const auto dwells = trackDwells(manager.plan(100.0, tracks));
  ASSERT_EQ(dwells.size(), 3u);
  EXPECT_EQ(dwells[0].beam.u, 0.4);
  EXPECT_EQ(dwells[1].beam.u, 0.2);
  EXPECT_EQ(dwells[2].beam.u, 0.0);
}

// Twenty tracks and eight dwells a period: nobody may starve, and search keeps its share.
TEST(ResourceManager, TheLimiterCutsTheListAndWhoWasCutComesNext) {
  ResourceManager manager(squareArray());
  std::vector<SteerableTrack> tracks;
  for (std::uint32_t i = 0; i < 20; ++i) tracks.push_back(track(i, -0.4 + 0.04001 * i));
  for (auto& one : tracks) one.revisit = 10.0;
  ArrayParams apart = squareArray();
  apart.sequence_distance = 0.5;
  manager = ResourceManager(apart);
  std::map<std::uint32_t, int> visits;
  for (int period = 0; period < 3; ++period) {
    const auto dwells = manager.plan(100.0 + 0.1 * period, tracks);
    ASSERT_EQ(dwells.size(), 10u);
    const auto chosen = trackDwells(dwells);
    EXPECT_EQ(chosen.size(), period < 2 ? 8u : 4u);
    for (const auto& dwell : chosen) ++visits[dwell.expected.at(0)];
  }
  EXPECT_EQ(visits.size(), 20u);
}

// A sequence longer than a period is what framing across resource periods is for.
TEST(ResourceManager, ASequenceThatWasCutGoesOnAtTheBeginOfTheNextPeriod) {
  ResourceManager manager(squareArray());
  std::vector<SteerableTrack> tracks;
  for (std::uint32_t i = 0; i < 25; ++i) tracks.push_back(track(i, 0.0125 * i));  // 7.5 beamwidths: 11 beams
  for (auto& one : tracks) one.revisit = 10.0;
  const auto first = trackDwells(manager.plan(100.0, tracks));
  const auto second = trackDwells(manager.plan(100.1, tracks));
  ASSERT_EQ(first.size(), 8u);
  ASSERT_EQ(second.size(), 3u);
  EXPECT_EQ(second[0].group, first[0].group);
  EXPECT_GT(second[0].beam.u, first[7].beam.u);
  EXPECT_EQ(first[0].group_dwells, 11u);
}

// A dropped track's number may be used again: the new track must not inherit the old one's dwells.
TEST(ResourceManager, ForgetsTracksThatAreGone) {
  ResourceManager manager(squareArray());
  SteerableTrack one = track(1, 0.0);
  EXPECT_EQ(trackDwells(manager.plan(100.0, {one})).size(), 1u);
  EXPECT_EQ(trackDwells(manager.plan(100.1, {one})).size(), 0u);
  manager.plan(100.2, {});
  EXPECT_EQ(trackDwells(manager.plan(100.3, {one})).size(), 1u);
}

TEST(CloseTogether, ChainsNeighboursAndPartsOthers) {
  const std::vector<SteerableTrack> tracks{track(0, 0.0), track(1, 0.2), track(2, 0.06), track(3, 0.03)};
  const std::vector<std::vector<std::size_t>> expected{{0, 3, 2}, {1}};
  EXPECT_EQ(closeTogether(squareArray(), tracks), expected);
}

TEST(NextExpectedDwell, IsTheEarliestLastUpdatePlusRevisitTime) {
  std::vector<SteerableTrack> tracks{track(1, 0.0), track(2, 0.1)};
  tracks[0].last_update = 10.0;
  tracks[0].revisit = 2.0;
  tracks[1].last_update = 11.0;
  tracks[1].revisit = 0.5;
  EXPECT_DOUBLE_EQ(*nextExpectedDwell(tracks, 11.2), 11.5);
  EXPECT_DOUBLE_EQ(*nextExpectedDwell(tracks, 11.7), 11.7);
  EXPECT_FALSE(nextExpectedDwell({}, 1.0).has_value());
}

}  // namespace
}  // namespace radar_sim
