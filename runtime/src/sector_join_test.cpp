#include "sector_join.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <tws_core/random_test_helpers.h>

#include "sector_join_test_helpers.h"

namespace tws_runtime {
namespace {

// If this fails, a tracker gets no sectors, or with the wrong plots and times.
TEST(SectorJoin, GivesEverySectorOnceAndInOrder) {
  Joined joined;
  joined.add(run(5, 200));
  expectRun(joined.sectors, 5, 200);
  EXPECT_TRUE(joined.faults.empty());
}

TEST(SectorJoin, ASectorIsGivenAsSoonAsBothItsMessagesAreThere) {
  Joined joined;
  joined.add({markOf(0), markOf(1)});
  EXPECT_TRUE(joined.sectors.empty());
  joined.add({detectionsOf(0)});
  EXPECT_EQ(joined.sectors.size(), 1u);
  joined.add({detectionsOf(1)});
  EXPECT_EQ(joined.sectors.size(), 1u);
  joined.add({markOf(2)});
  EXPECT_EQ(joined.sectors.size(), 2u);
}

/// The messages in an order of arrival in which none comes more than `skew` of data time after a later one. The first
/// of each of the two topics stays first.
std::vector<Message> shuffled(const std::vector<Message>& messages, double skew, std::mt19937_64& random) {
  std::uniform_real_distribution<double> delay(0.0, skew);
  std::vector<std::pair<double, Message>> arrivals;
  for (std::size_t i = 0; i < messages.size(); ++i)
    arrivals.emplace_back(i < 2 ? -1.0 : timeOf(messages[i]) + delay(random), messages[i]);
  const auto earlier = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::stable_sort(arrivals.begin(), arrivals.end(), earlier);
  std::vector<Message> order;
  for (auto& arrival : arrivals) order.push_back(std::move(arrival.second));
  return order;
}

// If this fails, a live run differs from its replay although nothing was lost.
TEST(SectorJoin, TheSectorsAreTheSameForEveryOrderOfArrivalWithinTheLimit) {
  std::mt19937_64 random = tws::seededGenerator();
  for (int trial = 0; trial < 300; ++trial) {
    Joined joined;
    joined.add(shuffled(run(0, 150), 0.49, random));
    expectRun(joined.sectors, 0, 150);
    ASSERT_TRUE(joined.faults.empty()) << joined.reasons.front();
  }
}

// If this fails, one lost message stops the tracker, or is lost in silence.
TEST(SectorJoin, LostDetectionsBecomeAnEmptySectorAndAreCounted) {
  std::vector<Message> messages = run(0, 40);
  drop<SectorDetections>(messages, 17);
  Joined joined;
  joined.add(messages);
  ASSERT_EQ(joined.sectors.size(), 41u);
  EXPECT_EQ(joined.sectors[17].running, 17);
  EXPECT_TRUE(joined.sectors[17].plots.empty());
  EXPECT_EQ(joined.sectors[17].leave_time, 18 * kSectorTime);
  EXPECT_EQ(joined.sectors[18].plots.size(), 2u);
  EXPECT_EQ(joined.faults, (std::map<std::string, int>{{"lost detections", 1}}));
  EXPECT_EQ(joined.reasons, std::vector<std::string>{"sector 17 (running 17), left at 2.25 s; its mark counts 1"});
}

TEST(SectorJoin, WhatIsLostIsWaitedForUntilTheLimitHasPassed) {
  std::vector<Message> messages = run(0, 10);
  drop<SectorDetections>(messages, 7);
  Joined joined;
  for (const Message& message : messages) {
    joined.add({message});
    // Sector 7 ends at 1.0 s; the limit is 0.5 s.
    if (timeOf(message) <= 1.5) {
      EXPECT_LE(joined.sectors.size(), 7u) << timeOf(message);
    }
  }
  Joined longer;
  messages = run(0, 12);
  drop<SectorDetections>(messages, 7);
  longer.add(messages);
  EXPECT_EQ(longer.sectors.size(), 13u);
}

TEST(SectorJoin, ALostMarkIsReplacedByTheTimeOfTheDetectionsAndCounted) {
  std::vector<Message> messages = run(0, 40);
  drop<SectorCrossing>(messages, 18);
  Joined joined;
  joined.add(messages);
  expectRun(joined.sectors, 0, 40);
  EXPECT_EQ(joined.faults, (std::map<std::string, int>{{"lost sector marks", 1}}));
  EXPECT_EQ(joined.reasons, std::vector<std::string>{"the one that closes sector 17 (running 17), left at 2.25 s"});
}

// Sectors 17 .. 19 vanish whole, with the marks 18, 19 and 20: their crossings lie evenly between those at 17 and 21.
TEST(SectorJoin, CrossingsOfWhichNothingCameAreInterpolated) {
  std::vector<Message> messages = run(0, 40);
  for (std::uint32_t sector = 17; sector <= 19; ++sector) {
    drop<SectorDetections>(messages, sector);
    drop<SectorCrossing>(messages, sector + 1);
  }
  Joined joined;
  joined.add(messages);
  ASSERT_EQ(joined.sectors.size(), 41u);
  for (std::size_t sector = 16; sector < 22; ++sector)
    EXPECT_NEAR(joined.sectors[sector].leave_time, kSectorTime * static_cast<double>(sector + 1), 1e-9);
  EXPECT_EQ(joined.faults, (std::map<std::string, int>{{"lost detections", 3}, {"lost sector marks", 3}}));
}

TEST(SectorJoin, DuplicatesAreDroppedAndCounted) {
  Joined joined;
  for (const Message& message : run(0, 50)) joined.add({message, message});
  expectRun(joined.sectors, 0, 50);
  EXPECT_EQ(joined.faults, (std::map<std::string, int>{{"duplicate messages", 103}}));
}

TEST(SectorJoin, AMessageThatComesAfterItsReplacementIsCountedAsLateAndNothingComesTwice) {
  std::vector<Message> messages = run(0, 40);
  drop<SectorDetections>(messages, 17);
  drop<SectorCrossing>(messages, 20);
  messages.push_back(detectionsOf(17));
  messages.push_back(markOf(20));
  messages.push_back(detectionsOf(17));
  Joined joined;
  joined.add(messages);
  EXPECT_EQ(joined.sectors.size(), 41u);
  EXPECT_EQ(joined.faults,
            (std::map<std::string, int>{
                {"lost detections", 1}, {"lost sector marks", 1}, {"late messages", 2}, {"duplicate messages", 1}}));
}

TEST(SectorJoin, ACountThatDiffersFromTheMarksIsSaidAndTheSectorIsGivenAllTheSame) {
  std::vector<Message> messages = run(0, 10);
  std::get<SectorCrossing>(messages[6]).closed_count = 7;  // The mark that closes sector 2.
  Joined joined;
  joined.add(messages);
  expectRun(joined.sectors, 0, 10);
  EXPECT_EQ(joined.faults, (std::map<std::string, int>{{"count mismatches", 1}}));
  EXPECT_EQ(joined.reasons,
            std::vector<std::string>{"sector 2 (running 2), left at 0.375 s: 2 detections came; its mark counts 7"});
}

// Whoever joins late takes part from the first sector that it received.
TEST(SectorJoin, AMessageFromBeforeTheFirstSectorIsLate) {
  Joined joined;
  joined.add(run(5, 10));
  joined.add({detectionsOf(4), markOf(5)});
  EXPECT_EQ(joined.sectors.front().running, 5);
  EXPECT_EQ(joined.faults, (std::map<std::string, int>{{"late messages", 1}, {"duplicate messages", 1}}));
}

TEST(SectorJoin, WhenTheTwoMessagesDisagreeTheMarkGivesTheTime) {
  std::vector<Message> messages = run(0, 10);
  for (Message& message : messages)
    if (auto* detections = std::get_if<SectorDetections>(&message)) detections->leave_time += 0.01;
  Joined joined;
  joined.add(messages);
  expectRun(joined.sectors, 0, 10);
}

// If this fails, losses under disorder stall the tracker, give a sector twice, or are counted wrongly.
TEST(SectorJoin, UnderRandomLossDuplicationAndDisorderEverySectorComesOnceAndEveryLossIsCounted) {
  std::mt19937_64 random = tws::seededGenerator();
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<Message> sent = run(0, 120);
    std::vector<Message> received(sent.begin(), sent.begin() + 2);
    int lost_detections = 0;
    int lost_marks = 0;
    int duplicates = 0;
    for (std::size_t i = 2; i < sent.size(); ++i) {
      const bool in_the_end = timeOf(sent[i]) > 110 * kSectorTime;  // Nothing is lost here, so all before is given.
      const auto chance = in_the_end ? 5u : random() % 10;
      if (chance == 0) ++(sent[i].index() == 0 ? lost_detections : lost_marks);
      if (chance == 1) ++duplicates;
      for (unsigned copy = 0; copy < (chance == 0 ? 0u : chance == 1 ? 2u : 1u); ++copy) received.push_back(sent[i]);
    }
    Joined joined;
    joined.add(shuffled(received, 0.49, random));
    ASSERT_EQ(joined.sectors.size(), 121u);
    for (std::size_t i = 0; i < joined.sectors.size(); ++i) {
      ASSERT_EQ(joined.sectors[i].running, static_cast<std::int64_t>(i));
      ASSERT_NEAR(joined.sectors[i].leave_time, kSectorTime * static_cast<double>(i + 1), 1e-9);
    }
    EXPECT_EQ(joined.faults["lost detections"], lost_detections);
    EXPECT_EQ(joined.faults["lost sector marks"], lost_marks);
    EXPECT_EQ(joined.faults["duplicate messages"], duplicates);
    EXPECT_EQ(joined.faults["late messages"] + joined.faults["stray messages"] + joined.faults["gaps"], 0);
  }
}

}  // namespace
}  // namespace tws_runtime
