#include "track_census.h"

#include <gtest/gtest.h>
#include <tws_msgs/Track.h>

namespace tws_launch {
namespace {

// A user reads from these numbers how many tracks a run had and how many were confirmed.

using tws_msgs::Track;

TEST(TrackCensus, CountsEachTrackOnceWhateverBecomesOfIt) {
  TrackCensus census;
  for (const auto state : {Track::TENTATIVE, Track::FIRM, Track::FIRM, Track::TENTATIVE, Track::FIRM})
    census.add(7, state);
  census.add(8, Track::TENTATIVE);
  census.add(8, Track::DROPPED);
  EXPECT_EQ(census.begun(), 2U);
  EXPECT_EQ(census.everFirm(), 1U);
  EXPECT_EQ(census.ended(), 1U);
  EXPECT_EQ(census.count(Track::FIRM), 1U);
  EXPECT_EQ(census.count(Track::TENTATIVE), 0U);
}

TEST(TrackCensus, CountsOneThatIsOnlyHeardOfAsItEnds) {
  TrackCensus census;
  census.add(7, Track::DROPPED);
  EXPECT_EQ(census.begun(), 1U);
}

// If this fails, days of a run take gigabytes: false plots start a track every few seconds.
TEST(TrackCensus, TracksThatEndedTakeNoMemory) {
  TrackCensus census;
  for (std::uint32_t uid = 0; uid < 1000000; ++uid) {
    census.add(uid, Track::FIRM);
    census.add(uid, Track::DROPPED);
    ASSERT_EQ(census.living(), 0U);
  }
  EXPECT_EQ(census.everFirm(), 1000000U);
}

}  // namespace
}  // namespace tws_launch
