#include "core/duplicate_tracks.h"

#include <gtest/gtest.h>

#include "core/adit_test_helpers.h"

namespace adit_tracker {
namespace {

/// Tracks that have flown 250 m/s for a minute, seen without errors each 6 s.
class DuplicateTracksTest : public testing::Test {
 protected:
  DuplicateTracksTest() { book_.begin({0, 100}, 10.0); }

  TrackFile::Slot track(double x, double y, double vx, double vy) {
    const auto plotAt = [&](double t) {
      tws::Plot plot;
      plot.time = t;
      plot.range = std::hypot(x + vx * (t - 60.0), y + vy * (t - 60.0));
      plot.azimuth = tws::wrapTwoPi(std::atan2(x + vx * (t - 60.0), y + vy * (t - 60.0)));
      return plot;
    };
    const auto slot = *book_.create(0, plotAt(0.0));
    for (double t = 6.0; t <= 60.0; t += 6.0)
      book_.motion().update(book_.at(slot), plotAt(t), radars_.at(0).quality, 0);
    book_.at(slot).existence = 0.9F;
    return slot;
  }
  void end(const std::vector<TrackFile::Slot>& slots, bool one_cluster = true, bool firm_too = true) {
    std::vector<Correlation> correlations;
    for (const auto slot : slots) {
      correlations.push_back({slot, nullptr, true});
      correlations.back().cluster = one_cluster ? 0 : correlations.size();
    }
    duplicates_.end(correlations, book_, firm_too);
  }

  AditCounts counts_;
  AditParams params_ = paramsFor("default", {6.0});
  Radars radars_{params_};
  TrackBook book_{params_, radars_, counts_};
  DuplicateTracks duplicates_;
};

// If this fails, one aircraft has two tracks for good.
TEST_F(DuplicateTracksTest, TheYoungerOfTwoTracksOnOneAircraftEnds) {
  const auto older = track(20e3, 50e3, 250.0, 0.0), younger = track(20.01e3, 50e3, 250.0, 0.0);
  end({younger, older});
  EXPECT_FALSE(book_.isDropped(older));
  EXPECT_TRUE(book_.isDropped(younger));
}

TEST_F(DuplicateTracksTest, AFirmTrackStaysBeforeAnOlderTentativeOne) {
  const auto older = track(20e3, 50e3, 250.0, 0.0), firm = track(20e3, 50e3, 250.0, 0.0);
  book_.at(firm).firm = true;
  end({older, firm});
  EXPECT_TRUE(book_.isDropped(older));
  EXPECT_FALSE(book_.isDropped(firm));
}

// If this fails, formations lose aircraft, and crossings one of two.
TEST_F(DuplicateTracksTest, AircraftThatOnlyMeetAreTwo) {
  const auto a = track(20e3, 50e3, 250.0, 0.0), crossing = track(20e3, 50e3, 230.0, 60.0);
  const auto abreast = track(20e3, 50.8e3, 250.0, 0.0);
  end({a, crossing, abreast});
  for (const auto slot : {a, crossing, abreast}) EXPECT_FALSE(book_.isDropped(slot));
}

// If this fails, one of two aircraft that overtake each other in one cell loses its track.
TEST_F(DuplicateTracksTest, WhereTwoTargetsMayGiveOnePlotTwoFirmTracksStay) {
  const auto a = track(20e3, 50e3, 250.0, 0.0), b = track(20e3, 50e3, 250.0, 0.0), c = track(20e3, 50e3, 250.0, 0.0);
  book_.at(a).firm = book_.at(b).firm = true;
  end({a, b, c}, true, false);
  EXPECT_FALSE(book_.isDropped(a) || book_.isDropped(b));
  EXPECT_TRUE(book_.isDropped(c));
}

TEST_F(DuplicateTracksTest, NothingIsComparedThatDidNotCompete) {
  const auto a = track(20e3, 50e3, 250.0, 0.0), b = track(20e3, 50e3, 250.0, 0.0);
  end({a, b}, false);
  EXPECT_FALSE(book_.isDropped(a) || book_.isDropped(b));
}

TEST_F(DuplicateTracksTest, OfThreeOnOneAircraftOneStays) {
  const auto a = track(20e3, 50e3, 250.0, 0.0), b = track(20e3, 50e3, 250.0, 0.0), c = track(20e3, 50e3, 250.0, 0.0);
  end({c, b, a});
  EXPECT_FALSE(book_.isDropped(a));
  EXPECT_TRUE(book_.isDropped(b) && book_.isDropped(c));
}

}  // namespace
}  // namespace adit_tracker
