#include "core/stitching.h"

#include <gtest/gtest.h>

#include "core/adit_test_helpers.h"
#include "core/plot_test_helpers.h"

namespace adit_tracker {
namespace {

constexpr double kPeriod = 6.0;

/// Firm tracks of targets that were seen without errors each 6 s.
class StitchingTest : public testing::Test {
 protected:
  StitchingTest() { book_.begin({0, 100}, 10.0); }

  /// Seen at (x, y) at `last` at the latest, and `scans` times before that.
  TrackFile::Slot track(double x, double y, double vx, double vy, double last, int scans) {
    const TestTarget target{x - vx * last, y - vy * last, vx, vy};
    const auto plot = [&](double t) { return plotAt(t, target.range(t), target.azimuth(t)); };
    const double first = last - 6.0 * scans;
    const auto slot = *book_.create(0, plot(first));
    for (int i = 1; i <= scans; ++i)
      book_.motion().update(book_.at(slot), plot(first + 6.0 * i), radars_.at(0).quality, 0);
    book_.at(slot).firm = true;
    book_.file().place(slot, 10);
    return slot;
  }

  /// Its last detection was at 60 s.
  TrackFile::Slot lost(double x, double y, double vx, double vy) {
    const auto slot = track(x, y, vx, vy, 60.0, 10);
    book_.setCoasting(slot, true);
    return slot;
  }
  /// Its first detection was at 72 s.
  TrackFile::Slot found(double x, double y, double vx, double vy) { return track(x, y, vx, vy, 84.0, 2); }

  AditCounts counts_;
  AditParams params_ = paramsFor("default", {6.0});
  Radars radars_{params_};
  TrackBook book_{params_, radars_, counts_};
  Stitching stitching_{params_};
};

// If this fails, an aircraft that turns about is another one for the operator from then on.
TEST_F(StitchingTest, ATrackThatBeginsWhereAnotherOneCouldHaveTurnedToTakesOverItsNumber) {
  const auto before = lost(20e3, 50e3, 250.0, 0.0);
  const auto after = found(18e3, 51.5e3, -250.0, 0.0);
  ASSERT_EQ(stitching_.lostBefore(book_, after, kPeriod), before);
  const std::uint32_t uid = book_.at(before).uid, number = book_.at(before).number;
  book_.at(before).designated = true;
  book_.succeed(after, before);
  EXPECT_EQ(book_.at(after).uid, uid);
  EXPECT_EQ(book_.at(after).number, number);
  EXPECT_TRUE(book_.at(after).designated);
  EXPECT_NE(book_.at(before).uid, uid);
  EXPECT_TRUE(book_.isDropped(before));
  EXPECT_FALSE(book_.isDropped(after));
  EXPECT_EQ(counts_.stitched, 1U);
}

// If this fails, a track's number leaps to another aircraft.
TEST_F(StitchingTest, ATrackThatIsStillDetectedKeepsItsNumber) {
  const auto before = lost(20e3, 50e3, 250.0, 0.0);
  book_.setCoasting(before, false);
  EXPECT_FALSE(stitching_.lostBefore(book_, found(18e3, 51.5e3, -250.0, 0.0), kPeriod));
}

TEST_F(StitchingTest, NothingIsStitchedThatCannotHaveFlownThere) {
  lost(20e3, 50e3, 250.0, 0.0);
  EXPECT_FALSE(stitching_.lostBefore(book_, found(20e3, 60e3, 0.0, 250.0), kPeriod)) << "10 km in 12 s";
  EXPECT_FALSE(stitching_.lostBefore(book_, found(20.5e3, 52e3, 0.0, 60.0), kPeriod)) << "from 250 m/s to 60";
}

TEST_F(StitchingTest, NothingIsStitchedThatWasLostLongAgo) {
  const auto before = lost(20e3, 50e3, 250.0, 0.0);
  const auto after = found(18e3, 51.5e3, -250.0, 0.0);
  book_.at(before).last_update -= params_.stitching.longest_gap * kPeriod;
  EXPECT_FALSE(stitching_.lostBefore(book_, after, kPeriod));
}

TEST_F(StitchingTest, OfTwoThatWereLostThereNeitherIsTakenUnlessOneIsClearlyNearer) {
  const auto near = lost(20e3, 50e3, 250.0, 0.0);
  const auto after = found(23e3, 52e3, 0.0, 250.0);
  const auto other = lost(20e3, 48e3, 250.0, 0.0);
  EXPECT_FALSE(stitching_.lostBefore(book_, after, kPeriod));
  book_.setCoasting(other, false);
  EXPECT_EQ(stitching_.lostBefore(book_, after, kPeriod), near);
}

TEST_F(StitchingTest, TheReportsTrackerStitchesNothing) {
  lost(20e3, 50e3, 250.0, 0.0);
  const Stitching none(AditParams::named("nrl7952"));
  EXPECT_FALSE(none.lostBefore(book_, found(18e3, 51.5e3, -250.0, 0.0), kPeriod));
}

/// An aircraft that flies back the way it came, from one scan to the next.
TEST(Stitching, AnAircraftThatTurnsAboutBetweenTwoScansKeepsItsTrack) {
  const TestRadar radar(6.0);
  RadarSectors radars = {radar.sectors(0.0, 240.0)};
  radar.see({-20e3, 40e3, 250.0, 0.0, 0.0, 120.0}, radars[0]);
  radar.see({-20e3 + 500.0 * 120.0, 41e3, -250.0, 0.0, 120.0}, radars[0]);
  Listener listener(paramsFor("default", {6.0}));
  feedInOrder(listener.adit, radars);
  listener.adit.finish();
  std::set<std::uint32_t> shown;  // What is dropped is the number that the new track had until then.
  for (const RecordedUpdate& w : listener.updates) {
    if (w.confirmed && w.event != TrackEvent::kDropped) shown.insert(w.uid);
  }
  EXPECT_EQ(shown.size(), 1U);
  EXPECT_EQ(listener.adit.counts().stitched, 1U);
}

}  // namespace
}  // namespace adit_tracker
