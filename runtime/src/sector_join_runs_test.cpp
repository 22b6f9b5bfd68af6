// What SectorJoin takes for one run of a radar, and how it gets over damage, gaps and restarts.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "sector_join.h"
#include "sector_join_test_helpers.h"

namespace tws_runtime {
namespace {

// If this fails, the sectors of a new run are taken for late ones of the old.
TEST(SectorJoinRuns, ANewRunBeginsAnew) {
  Joined joined;
  joined.add(run(0, 100));
  joined.join.beginNewRun();
  joined.sectors.clear();
  joined.add(run(0, 50));
  expectRun(joined.sectors, 0, 50);
}

// If this fails, a single damaged message throws away all tracks or stalls the radar.
TEST(SectorJoinRuns, OneWrongStampOrNumberDoesNoHarm) {
  for (const double wrong_time : {0.0, 1e9, 20.0}) {
    std::vector<Message> messages = run(0, 100);
    std::get<SectorCrossing>(messages[120]).time = wrong_time;  // The mark that closes sector 59.
    Joined joined;
    joined.add(messages);
    expectRun(joined.sectors, 0, 100);
    EXPECT_EQ(joined.faults, (std::map<std::string, int>{{"lost sector marks", 1}, {"stray messages", 1}}))
        << wrong_time;
  }
  for (const std::uint32_t wrong_number : {0u, 4294967295u, 100000u}) {
    std::vector<Message> messages = run(0, 100);
    std::get<SectorCrossing>(messages[120]).running = wrong_number;
    Joined joined;
    joined.add(messages);
    expectRun(joined.sectors, 0, 100);
    EXPECT_EQ(joined.faults["stray messages"], 1);
  }
}

// If this fails, a sector whose time was damaged on its way takes its radar's tracks with it.
TEST(SectorJoinRuns, DetectionsAndTheirMarkThatAreDamagedTogetherDoNoHarm) {
  for (const double off : {-86400.0, 86400.0, 30.0}) {
    std::vector<Message> messages = run(0, 100);
    std::get<SectorDetections>(messages[119]).leave_time += off;
    std::get<SectorCrossing>(messages[120]).time += off;
    Joined joined;
    joined.add(messages);
    ASSERT_EQ(joined.sectors.size(), 101u) << off;
    EXPECT_EQ(joined.faults["stray messages"], 2);
    EXPECT_EQ(joined.faults["gaps"], 0);
  }
}

TEST(SectorJoinRuns, AnOutlierThatComesTwiceDoesNoHarmEither) {
  std::vector<Message> messages = run(0, 100);
  std::get<SectorCrossing>(messages[120]).time = 0.0;
  const Message outlier = messages[120];
  messages.insert(messages.begin() + 120, outlier);
  Joined joined;
  joined.add(messages);
  expectRun(joined.sectors, 0, 100);
  EXPECT_EQ(joined.faults["stray messages"], 2);
}

TEST(SectorJoinRuns, AWrongFirstStampIsOvercome) {
  std::vector<Message> messages = run(0, 100);
  std::get<SectorCrossing>(messages[0]).time = 1e9;
  Joined joined;
  joined.add(messages);
  ASSERT_GE(joined.sectors.size(), 100u);
  EXPECT_EQ(joined.sectors.back().running, 100);
  EXPECT_EQ(joined.faults["gaps"], 1);
}

// Two messages a microsecond apart say that a turn takes 64 us; the radar must not be lost for good.
TEST(SectorJoinRuns, TwoCrossingsAtNearlyOneTimeAreOvercome) {
  Joined joined;
  SectorCrossing second = markOf(1);
  second.time = 1e-6;
  joined.add({markOf(0), second});
  joined.add(run(2, 60));
  ASSERT_FALSE(joined.sectors.empty());
  EXPECT_EQ(joined.sectors.back().running, 60);
}

// If this fails, a radar that was switched off and on is ignored, or two sectors get one number.
TEST(SectorJoinRuns, ARadarThatCountsAnewGoesOnWithNumbersOfTheSameSectors) {
  Joined joined;
  joined.add(run(0, 100));
  joined.add(run(3, 40, 60.0));
  EXPECT_EQ(joined.faults["gaps"], 1);
  ASSERT_EQ(joined.sectors.size(), 139u);
  EXPECT_EQ(joined.sectors[101].sector, 3);
  EXPECT_EQ(joined.sectors[101].running, 131);  // The first after 100 that is 3 modulo 64.
  EXPECT_EQ(joined.sectors[101].enter_time, 60.0 + 3 * kSectorTime);
  EXPECT_EQ(joined.sectors.back().running, 168);
}

TEST(SectorJoinRuns, AShortSilenceIsFilledWithEmptySectorsAndALongOneIsLeftOut) {
  Joined joined;
  joined.add(run(0, 100));
  joined.add(run(141, 200));  // 40 sectors are missing, 101 .. 140.
  ASSERT_EQ(joined.sectors.size(), 201u);
  EXPECT_TRUE(joined.sectors[120].plots.empty());
  EXPECT_NEAR(joined.sectors[120].enter_time, 120 * kSectorTime, 1e-9);
  joined.add(run(2000, 2050));
  ASSERT_EQ(joined.sectors.size(), 252u);
  EXPECT_EQ(joined.sectors[201].running, 2000);
  EXPECT_EQ(joined.faults["gaps"], 1);
}

// If this fails, plots are lost with a mark just before the radar falls silent.
TEST(SectorJoinRuns, WhatWaitsBeforeAGapIsGivenBeforeIt) {
  Joined joined;
  std::vector<Message> messages = run(0, 7);
  messages.pop_back();  // The mark that closes sector 7, which has three plots.
  joined.add(messages);
  EXPECT_EQ(joined.sectors.size(), 7u);
  joined.add(run(2000, 2010));
  ASSERT_EQ(joined.sectors.size(), 19u);
  EXPECT_EQ(joined.sectors[7].plots.size(), 3u);
  EXPECT_EQ(joined.sectors[8].running, 2000);
}

TEST(SectorJoinRuns, WithoutAnyMarkOrWithoutAnyDetectionsSectorsComeAllTheSame) {
  Joined without_marks;
  Joined without_detections;
  for (const Message& message : run(0, 40)) (message.index() == 0 ? without_marks : without_detections).add({message});
  EXPECT_GE(without_marks.sectors.size(), 35u);
  EXPECT_GE(without_detections.sectors.size(), 35u);
  EXPECT_EQ(without_marks.faults["lost sector marks"], static_cast<int>(without_marks.sectors.size()));
  EXPECT_EQ(without_detections.faults["lost detections"], static_cast<int>(without_detections.sectors.size()));
}

TEST(SectorJoinRuns, AFirstSectorWithoutItsOwnMarkBeginsAShareOfTheTurnBeforeItsEnd) {
  Joined joined;
  joined.add({detectionsOf(9), markOf(10)});
  ASSERT_EQ(joined.sectors.size(), 1u);
  EXPECT_NEAR(joined.sectors[0].enter_time, 9 * kSectorTime, 1e-12);
}

TEST(SectorJoinRuns, NumbersGoOnWhereThoseOfTheMessagesWrap) {
  Joined joined;
  const std::uint32_t before = 4294967295u - 9;  // Ten sectors before 2^32.
  for (std::uint32_t i = 0; i < 30; ++i) {
    SectorCrossing mark = markOf(i);
    SectorDetections detections = detectionsOf(i);
    mark.running += before;
    detections.running += before;
    joined.add({mark, detections});
  }
  ASSERT_EQ(joined.sectors.size(), 29u);
  EXPECT_EQ(joined.sectors.back().running, std::int64_t{4294967286} + 28);
  EXPECT_EQ(joined.sectors.back().sector, 18);
  EXPECT_TRUE(joined.faults.empty());
}

// If this fails, one bad plot reaches the tracker's filters.
TEST(SectorJoinRuns, APlotFarFromItsSectorsTimeIsDroppedAndTheOthersAreSorted) {
  SectorDetections detections = detectionsOf(3);
  std::swap(detections.plots[0], detections.plots[2]);
  detections.plots[1].time = 1e6;
  Joined joined;
  joined.add({markOf(3), detections, markOf(4)});
  ASSERT_EQ(joined.sectors.size(), 1u);
  ASSERT_EQ(joined.sectors[0].plots.size(), 2u);
  EXPECT_EQ(joined.sectors[0].plots[0].range, 3000.0);
  EXPECT_EQ(joined.sectors[0].plots[1].range, 3002.0);
  EXPECT_EQ(joined.faults, (std::map<std::string, int>{{"bad detections", 1}}));
}

}  // namespace
}  // namespace tws_runtime
