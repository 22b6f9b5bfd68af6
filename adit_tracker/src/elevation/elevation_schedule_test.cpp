#include "elevation/elevation_schedule.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

namespace adit_tracker {
namespace {

using Uid = ElevationSchedule::Uid;
using Uids = std::vector<Uid>;

/// With the report's numbers unless changed.
class ElevationScheduleTest : public testing::Test {
 protected:
  void designate(const Uids& tracks) {
    for (const Uid track : tracks) schedule.designate(track);
  }
  /// The radar tries all designated tracks on a scan.
  void tryAll() {
    for (const Uid track : schedule.designated()) schedule.tried(track);
  }
  /// So many scans, of which nothing is expected.
  void scans(int count) {
    for (int i = 0; i < count; ++i) {
      schedule.next();
      tryAll();
    }
  }

  ElevationSchedule schedule{ElevationParams{}};
};

// Who relies on the report's numbers gets a search at once and then one on every fourth scan.
TEST_F(ElevationScheduleTest, ATrackIsSearchedForAtOnceAndThenOnEveryFourthScan) {
  designate({7});
  std::vector<int> searched;
  for (int scan = 0; scan < 14; ++scan) {
    if (!schedule.next().empty()) searched.push_back(scan);
    tryAll();
  }
  EXPECT_EQ(searched, (std::vector<int>{0, 4, 8, 12}));
}

// A try is one whether the track was detected or not; without tries (the radar is silent) nothing is asked again.
TEST_F(ElevationScheduleTest, WithoutTriesNothingComesAgain) {
  designate({7});
  EXPECT_EQ(schedule.next(), (Uids{7}));
  for (int scan = 0; scan < 10; ++scan) EXPECT_TRUE(schedule.next().empty());
}

TEST_F(ElevationScheduleTest, TriesBeforeTheFirstSearchDoNotCount) {
  designate({1, 2, 3, 4, 5});
  for (int i = 0; i < 10; ++i) schedule.tried(5);
  EXPECT_EQ(schedule.next(), (Uids{1, 2, 3, 4}));
  EXPECT_EQ(schedule.waiting(), 0U);
  EXPECT_EQ(schedule.next(), (Uids{5}));
}

// NDESTAR has four places a scan.
TEST_F(ElevationScheduleTest, OfMoreThanFourNewOnesTheRestWaitsForTheNextScan) {
  designate({10, 11, 12, 13, 14, 15, 16, 17, 18});
  EXPECT_EQ(schedule.next(), (Uids{10, 11, 12, 13}));
  EXPECT_EQ(schedule.next(), (Uids{14, 15, 16, 17}));
  EXPECT_EQ(schedule.next(), (Uids{18}));
  EXPECT_TRUE(schedule.next().empty());
}

/// The page after "Designated Targets": INUM newly designated, NCOUNT previously designated.
class WorkedCase : public ElevationScheduleTest {
 protected:
  /// Tracks 1 to `count`, which wait in this order.
  void letWait(Uid count) {
    for (Uid track = 1; track <= count; ++track) {
      schedule.designate(track);
      schedule.next();
    }
    for (int i = 0; i < 4; ++i) tryAll();
    ASSERT_EQ(schedule.waiting(), count);
  }
};

// "If INUM + NCOUNT <= 8, all track numbers are stored into NTEMP and NCOUNT is set to 0."
TEST_F(WorkedCase, UpToEightAllAreSearchedFor) {
  letWait(5);
  designate({101, 102, 103});
  EXPECT_EQ(schedule.next(), (Uids{101, 102, 103, 1, 2, 3, 4, 5}));
  EXPECT_EQ(schedule.waiting(), 0U);
}

// "If > 8, the INUM targets newly designated and the first (8 - INUM) targets previously designated are stored in
// NTEMP. NCOUNT is reset to INUM + NCOUNT - 8, and the unused previously designated targets are stored in the first
// NCOUNT locations of NTARPR": here INUM = 3, NCOUNT = 7.
TEST_F(WorkedCase, BeyondEightTheOldOnesThatAreLeftComeFirstNextTime) {
  letWait(7);
  designate({101, 102, 103});
  EXPECT_EQ(schedule.next(), (Uids{101, 102, 103, 1, 2, 3, 4, 5}));
  EXPECT_EQ(schedule.waiting(), 2U);  // 3 + 7 - 8
  designate({104});
  EXPECT_EQ(schedule.next(), (Uids{104, 6, 7}));
  EXPECT_EQ(schedule.waiting(), 0U);
}

TEST_F(WorkedCase, WhoJoinsLaterStandsBehindThoseLeftOver) {
  letWait(8);
  designate({101, 102, 103, 104});
  EXPECT_EQ(schedule.next(), (Uids{101, 102, 103, 104, 1, 2, 3, 4}));
  for (int i = 0; i < 4; ++i) schedule.tried(1);  // its turn comes again
  EXPECT_EQ(schedule.next(), (Uids{5, 6, 7, 8, 1}));
}

// A dropped track in the list would send the radar to where nothing is, and cost another one its search.
TEST_F(WorkedCase, WhoIsRemovedLeavesAllLists) {
  letWait(4);
  designate({101, 102});
  schedule.remove(2);
  schedule.remove(101);
  EXPECT_EQ(schedule.next(), (Uids{102, 1, 3, 4}));
  EXPECT_FALSE(schedule.isDesignated(2));
  schedule.designate(2);  // anew
  EXPECT_EQ(schedule.next(), (Uids{2}));
}

// With more than per_scan · every_scans tracks nobody waits for ever, and nobody is listed twice.
TEST_F(ElevationScheduleTest, WithFortyTracksEachHasItsTurnWithinFiveScans) {
  Uids all(40);
  std::iota(all.begin(), all.end(), 1U);
  designate(all);
  scans(20);
  std::map<Uid, int> searches;
  for (int scan = 0; scan < 50; ++scan) {
    const Uids next = schedule.next();
    EXPECT_EQ(next.size(), 8U);
    for (const Uid track : next) ++searches[track];
    tryAll();
  }
  for (const Uid track : all) EXPECT_EQ(searches[track], 10) << track;
}

TEST(ElevationScheduleParams, TheNumbersAreParameters) {
  ElevationParams params;
  params.per_scan = 3;
  params.new_per_scan = 2;
  params.every_scans = 1;
  ElevationSchedule schedule(params);
  for (const Uid track : {1U, 2U, 3U, 4U}) schedule.designate(track);
  EXPECT_EQ(schedule.next(), (Uids{1, 2}));
  schedule.tried(1);
  schedule.tried(2);
  EXPECT_EQ(schedule.next(), (Uids{3, 4, 1}));
  EXPECT_EQ(schedule.next(), (Uids{2}));
}

}  // namespace
}  // namespace adit_tracker
