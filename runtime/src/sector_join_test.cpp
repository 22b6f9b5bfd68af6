#include "sector_join.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace tws_runtime {
namespace {

using Message = std::variant<SectorDetections, SectorCrossing>;
constexpr double kSectorTime = 0.125;  // An eight-second turn.

SectorDetections detectionsOf(std::uint32_t sector, double epoch = 0.0) {
  SectorDetections detections;
  detections.running = sector;
  detections.leave_time = epoch + kSectorTime * (sector + 1);
  for (std::uint32_t i = 0; i < sector % 4; ++i) {  // None to three plots, told apart by their ranges.
    tws::Plot plot;
    plot.time = epoch + kSectorTime * (sector + 0.25 * i);
    plot.range = 1000.0 * sector + i;
    detections.plots.push_back(plot);
  }
  detections.sent_count = detections.plots.size();
  return detections;
}

SectorCrossing markOf(std::uint32_t entered, double epoch = 0.0) {
  SectorCrossing mark;
  mark.running = entered;
  mark.time = epoch + kSectorTime * entered;
  mark.closed_count = (entered + 3) % 4;  // Of the sector before.
  mark.rotation_period = 64.0 * kSectorTime;
  return mark;
}

/// What a radar sends from sector `from` up to and with sector `to`, as it sends it.
std::vector<Message> run(std::uint32_t from, std::uint32_t to, double epoch = 0.0) {
  std::vector<Message> messages{markOf(from, epoch)};
  for (std::uint32_t sector = from; sector <= to; ++sector) {
    messages.push_back(detectionsOf(sector, epoch));
    messages.push_back(markOf(sector + 1, epoch));
  }
  return messages;
}

double timeOf(const Message& message) {
  if (const auto* detections = std::get_if<SectorDetections>(&message)) return detections->leave_time;
  return std::get<SectorCrossing>(message).time;
}

/// A join and what came out of it.
struct Joined {
  std::vector<tws::RadarSector> sectors;
  std::vector<double> new_runs;
  std::map<std::string, int> faults;
  std::vector<std::string> reasons;
  SectorJoin join{SectorJoin::Options(), events()};

  SectorJoin::Events events() {
    return {[this](tws::RadarSector sector) { sectors.push_back(std::move(sector)); },
            [this](double time) { new_runs.push_back(time); },
            [this](const std::string& counter, const std::string& reason) {
              ++faults[counter];
              reasons.push_back(reason);
            }};
  }
  void add(const std::vector<Message>& messages) {
    for (const Message& message : messages) std::visit([this](const auto& each) { join.add(each); }, message);
  }
};

/// Every sector from `from` to `to` just once, in order, with the times at which the beam crossed and its number of
/// plots.
void expectRun(const std::vector<tws::RadarSector>& sectors, std::uint32_t from, std::uint32_t to) {
  ASSERT_EQ(sectors.size(), to - from + 1);
  for (std::uint32_t i = 0; i < sectors.size(); ++i) {
    const std::uint32_t running = from + i;
    EXPECT_EQ(sectors[i].running, running);
    EXPECT_EQ(sectors[i].sector, static_cast<int>(running % 64));
    EXPECT_NEAR(sectors[i].enter_time, kSectorTime * running, 1e-9);
    EXPECT_NEAR(sectors[i].leave_time, kSectorTime * (running + 1), 1e-9);
    EXPECT_EQ(sectors[i].plots.size(), running % 4);
  }
}

template <class Kind>
void drop(std::vector<Message>& messages, std::uint32_t running) {
  const auto is_it = [&](const Message& message) {
    const auto* kind = std::get_if<Kind>(&message);
    return kind && kind->running == running;
  };
  messages.erase(std::remove_if(messages.begin(), messages.end(), is_it), messages.end());
}

// If this fails, a tracker gets no sectors, or with the wrong plots and times.
TEST(SectorJoin, GivesEverySectorOnceAndInOrder) {
  Joined joined;
  joined.add(run(5, 200));
  expectRun(joined.sectors, 5, 200);
  EXPECT_TRUE(joined.faults.empty());
  EXPECT_TRUE(joined.new_runs.empty());
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
std::vector<Message> shuffled(const std::vector<Message>& messages, double skew, std::mt19937& random) {
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
  const std::mt19937::result_type seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
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
  EXPECT_EQ(joined.reasons.front(), "sector 17 (running 17), left at 2.25 s; its mark counts 1");
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
  EXPECT_EQ(joined.reasons.front(), "the one that closes sector 17 (running 17), left at 2.25 s");
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
  EXPECT_EQ(joined.reasons.front(), "sector 2 (running 2), left at 0.375 s: 2 detections came; its mark counts 7");
}

// If this fails, losses under disorder stall the tracker, give a sector twice, or are counted wrongly.
TEST(SectorJoin, UnderRandomLossDuplicationAndDisorderEverySectorComesOnceAndEveryLossIsCounted) {
  const std::mt19937::result_type seed = std::random_device{}();
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 random(seed);
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

// If this fails, the tracks of the last run live on in a bag that is played again.
TEST(SectorJoin, TimeThatGoesBackBeginsANewRun) {
  Joined joined;
  joined.add(run(0, 100));
  joined.add(run(0, 50));
  ASSERT_EQ(joined.new_runs.size(), 1u);
  EXPECT_EQ(joined.new_runs[0], 0.0);
  ASSERT_EQ(joined.sectors.size(), 152u);
  joined.sectors.erase(joined.sectors.begin(), joined.sectors.begin() + 101);
  expectRun(joined.sectors, 0, 50);
}

// If this fails, a single damaged message throws away all tracks or stalls the radar.
TEST(SectorJoin, OneMadStampOrNumberDoesNoHarm) {
  for (const double mad_time : {0.0, 1e9, 20.0}) {
    std::vector<Message> messages = run(0, 100);
    std::get<SectorCrossing>(messages[120]).time = mad_time;  // The mark that closes sector 59.
    Joined joined;
    joined.add(messages);
    expectRun(joined.sectors, 0, 100);
    EXPECT_EQ(joined.faults, (std::map<std::string, int>{{"lost sector marks", 1}, {"stray messages", 1}})) << mad_time;
    EXPECT_TRUE(joined.new_runs.empty());
  }
  for (const std::uint32_t mad_number : {0u, 4294967295u, 100000u}) {
    std::vector<Message> messages = run(0, 100);
    std::get<SectorCrossing>(messages[120]).running = mad_number;
    Joined joined;
    joined.add(messages);
    expectRun(joined.sectors, 0, 100);
    EXPECT_EQ(joined.faults["stray messages"], 1);
    EXPECT_TRUE(joined.new_runs.empty());
  }
}

TEST(SectorJoin, AMadFirstStampIsOvercome) {
  std::vector<Message> messages = run(0, 100);
  std::get<SectorCrossing>(messages[0]).time = 1e9;
  Joined joined;
  joined.add(messages);
  ASSERT_GE(joined.sectors.size(), 100u);
  EXPECT_EQ(joined.sectors.back().running, 100);
  EXPECT_EQ(joined.new_runs.size(), 1u);
}

// Two messages a microsecond apart say that a turn takes 64 us; the radar must not be lost for good.
TEST(SectorJoin, TwoCrossingsAtNearlyOneTimeAreOvercome) {
  Joined joined;
  SectorCrossing second = markOf(1);
  second.time = 1e-6;
  joined.add({markOf(0), second});
  joined.add(run(2, 60));
  ASSERT_FALSE(joined.sectors.empty());
  EXPECT_EQ(joined.sectors.back().running, 60);
}

// If this fails, a radar that was switched off and on is ignored, or two sectors get one number.
TEST(SectorJoin, ARadarThatCountsAnewGoesOnWithNumbersOfTheSameSectors) {
  Joined joined;
  joined.add(run(0, 100));
  joined.add(run(3, 40, 60.0));
  EXPECT_TRUE(joined.new_runs.empty());
  EXPECT_EQ(joined.faults["gaps"], 1);
  ASSERT_EQ(joined.sectors.size(), 139u);
  EXPECT_EQ(joined.sectors[101].sector, 3);
  EXPECT_EQ(joined.sectors[101].running, 131);  // The first after 100 that is 3 modulo 64.
  EXPECT_EQ(joined.sectors[101].enter_time, 60.0 + 3 * kSectorTime);
  EXPECT_EQ(joined.sectors.back().running, 168);
}

TEST(SectorJoin, AShortSilenceIsFilledWithEmptySectorsAndALongOneIsLeftOut) {
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
TEST(SectorJoin, WhatWaitsBeforeAGapIsGivenBeforeIt) {
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

TEST(SectorJoin, WithoutAnyMarkOrWithoutAnyDetectionsSectorsComeAllTheSame) {
  Joined without_marks;
  Joined without_detections;
  for (const Message& message : run(0, 40)) (message.index() == 0 ? without_marks : without_detections).add({message});
  EXPECT_GE(without_marks.sectors.size(), 35u);
  EXPECT_GE(without_detections.sectors.size(), 35u);
  EXPECT_EQ(without_marks.faults["lost sector marks"], static_cast<int>(without_marks.sectors.size()));
  EXPECT_EQ(without_detections.faults["lost detections"], static_cast<int>(without_detections.sectors.size()));
}

TEST(SectorJoin, AFirstSectorWithoutItsOwnMarkBeginsAShareOfTheTurnBeforeItsEnd) {
  Joined joined;
  joined.add({detectionsOf(9), markOf(10)});
  ASSERT_EQ(joined.sectors.size(), 1u);
  EXPECT_NEAR(joined.sectors[0].enter_time, 9 * kSectorTime, 1e-12);
}

TEST(SectorJoin, NumbersGoOnWhereThoseOfTheMessagesWrap) {
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

// If this fails, one mad plot reaches the tracker's filters.
TEST(SectorJoin, APlotFarFromItsSectorsTimeIsDroppedAndTheOthersAreSorted) {
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
