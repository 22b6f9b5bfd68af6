#include "core/next_meeting.h"

#include <gtest/gtest.h>

#include "core/adit_test_helpers.h"
#include "core/track_book.h"

namespace adit_tracker {
namespace {

/// Two radars of 6 and 8 s, whose beams point to north at t = 0, and a track that stands in the east.
class NextMeetingTest : public testing::Test {
 protected:
  NextMeetingTest() {
    for (std::int64_t i = 0; i <= 64; ++i) {
      for (std::size_t radar = 0; radar < 2; ++radar) {
        const double duration = kPeriods[radar] / tws::kSectors;
        radars_.at(radar).antenna.cross(i, duration * static_cast<double>(i));
      }
    }
    tws::Plot plot;
    plot.time = 1.5;
    plot.range = 50e3;
    plot.azimuth = kAzimuth;
    slot_ = *book_.create(0, plot);
    book_.start(slot_, 0, nullptr, kAzimuth);
  }

  /// Both radars have been processed up to that time [s].
  void processUpTo(double time) {
    for (std::size_t radar = 0; radar < 2; ++radar) {
      const double duration = kPeriods[radar] / tws::kSectors;
      for (std::int64_t i = order_.newest(radar) + 1; duration * static_cast<double>(i + 1) <= time; ++i)
        order_.add({radar, i}, duration * static_cast<double>(i), duration * static_cast<double>(i + 1));
    }
    while (order_.next()) continue;
  }

  static constexpr double kAzimuth = 0.5 * tws::kPi + 0.02;
  static constexpr double kPeriods[] = {6.0, 8.0};
  AditParams params_ = paramsFor("default", {6.0, 8.0});
  AditCounts counts_;
  Radars radars_{params_};
  tws::SectorOrder order_{2, 1.0, 0};
  TrackBook book_{params_, radars_, counts_};
  NextMeeting meeting_{radars_, order_, book_.motion(), book_.file()};
  TrackFile::Slot slot_ = 0;
};

// If this fails, a track is looked for by one radar only, and missed by the other.
TEST_F(NextMeetingTest, IsWithTheRadarWhoseBeamComesFirst) {
  processUpTo(1.7);
  meeting_.predict(book_.at(slot_), 0);
  EXPECT_EQ(book_.at(slot_).predicted.radar, 1U);
  EXPECT_NEAR(book_.at(slot_).predicted.time, 2.0, 0.05);
  book_.at(slot_).illuminated[1] = kAzimuth;
  meeting_.predict(book_.at(slot_), 0);
  EXPECT_EQ(book_.at(slot_).predicted.radar, 0U);
  EXPECT_NEAR(book_.at(slot_).predicted.time, 7.5, 0.05);
}

TEST_F(NextMeetingTest, ListsATrackOnceAScanOfEachRadar) {
  processUpTo(1.7);
  meeting_.enter(slot_, 0);
  const std::int64_t east = 16;
  NextMeeting::Slots met, first;
  meeting_.list({0, east}, met);
  EXPECT_TRUE(met.empty());  // radar 0 has met it when it started
  meeting_.list({1, east}, first);
  EXPECT_EQ(first, NextMeeting::Slots{slot_});
}

// If this fails, a track that moves into a sector which the other radar has just left is not updated for a scan.
TEST_F(NextMeetingTest, ATrackStaysInItsSectorWhileAnotherRadarWouldMissIt) {
  processUpTo(1.95);
  const int front = static_cast<int>(order_.front(1));
  book_.file().place(slot_, front);
  book_.at(slot_).predicted.azimuth = tws::sectorStart(front - 1) + 0.01;
  meeting_.moveOn(slot_, 0);
  EXPECT_EQ(book_.file().sector(slot_), front);
  processUpTo(2.2);  // now radar 1 has processed both
  meeting_.moveOn(slot_, 0);
  EXPECT_EQ(book_.file().sector(slot_), front - 1);
}

}  // namespace
}  // namespace adit_tracker
