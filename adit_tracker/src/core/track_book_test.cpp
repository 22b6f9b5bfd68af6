#include "core/track_book.h"

#include <gtest/gtest.h>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

class TrackBookTest : public testing::Test {
 protected:
  TrackBookTest() { book_.begin({0, 100}, 10.0); }

  static tws::Plot plotAt(double time) {
    tws::Plot plot;
    plot.time = time;
    plot.range = 50e3;
    plot.azimuth = 1.0;
    return plot;
  }
  TrackFile::Slot started(double time = 10.0) {
    const TrackFile::Slot slot = *book_.create(0, plotAt(time));
    book_.start(slot, 0, nullptr, tws::Antenna::near(1.0, 100));
    book_.file().place(slot, tws::sectorOf(1.0));
    return slot;
  }
  std::vector<TrackEvent> events() const {
    std::vector<TrackEvent> events;
    for (const auto& each : book_.latest().updates) events.push_back(each.event);
    return events;
  }

  AditParams params() const {
    AditParams params = paramsFor("default", {6.0});
    params.capacity = 3;  // of which two can be used
    return params;
  }
  AditCounts counts_;
  Radars radars_{params()};
  TrackBook book_{params(), radars_, counts_};
};

TEST_F(TrackBookTest, ReportsWhatBecameOfEachTrackInASector) {
  const auto slot = started();
  EXPECT_EQ(events(), std::vector<TrackEvent>{TrackEvent::kStarted});
  EXPECT_EQ(book_.at(slot).updated[0], 10.0);
  book_.end();
  book_.begin({0, 164}, 16.0);
  book_.update(slot, {0, 164}, radars_.at(0).quality, plotAt(16.0), nullptr, false);
  EXPECT_EQ(events(), std::vector<TrackEvent>{TrackEvent::kUpdated});
  EXPECT_EQ(book_.at(slot).updates, 2);
}

// If this fails, a number is given away while the report of its old track is still being published.
TEST_F(TrackBookTest, ANumberIsFreeOnlyAfterTheSectorInWhichItsTrackWasDropped) {
  const auto slot = started();
  started();
  EXPECT_FALSE(book_.create(0, plotAt(10.0)));
  EXPECT_EQ(counts_.refused_tracks, 1U);
  book_.drop(slot, 10.0);
  EXPECT_TRUE(book_.isDropped(slot));
  EXPECT_FALSE(book_.create(0, plotAt(10.0)));
  book_.end();
  EXPECT_TRUE(book_.create(0, plotAt(10.0)));
}

// If this fails, what an operator drops between two sectors is never published as dropped.
TEST_F(TrackBookTest, WhatOperatorsDoComesWithTheNextSector) {
  const auto slot = started();
  book_.end();
  book_.dropByHand(slot);
  EXPECT_TRUE(book_.living().empty());
  EXPECT_FALSE(book_.find(book_.at(slot).number));
  book_.begin({0, 101}, 10.1);
  EXPECT_EQ(events(), std::vector<TrackEvent>{TrackEvent::kDropped});
  EXPECT_TRUE(book_.isDropped(slot));
  book_.end();
  EXPECT_EQ(book_.size(), 0U);
}

TEST_F(TrackBookTest, AMissedTrackCoastsUntilItIsDropped) {
  const auto slot = started();
  int coasted = 0;
  for (std::int64_t scan = 1; scan < 30; ++scan) {
    book_.end();
    book_.begin({0, 100 + 64 * scan}, 10.0 + 6.0 * static_cast<double>(scan));
    book_.motion().predict(book_.at(slot), 0, book_.latest().enter_time, radars_.quality(0));
    if (!book_.miss(slot, {0, 100 + 64 * scan})) break;
    EXPECT_TRUE(book_.at(slot).coasting);
    ++coasted;
  }
  EXPECT_EQ(events(), std::vector<TrackEvent>{TrackEvent::kDropped});
  EXPECT_LT(coasted, 10);
}

}  // namespace
}  // namespace adit_tracker
