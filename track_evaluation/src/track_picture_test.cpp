#include "track_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "message_test_helpers.h"

namespace track_evaluation {
namespace {

// If one of these fails, a tracker is judged by another picture than the one it showed.

using tws_msgs::Track;

TEST(TrackPicture, MovesTheLatestUpdateOnByItsVelocity) {
  TrackPicture picture(30.0);
  picture.add(tracksAt(10, {firmTrack(5, 9.0, 1000, 0, 100)}));
  picture.add(tracksAt(12, {firmTrack(5, 11.0, 1190, 0, 90)}));
  const auto tracks = picture.at(13.0);
  ASSERT_EQ(tracks.size(), 1U);
  EXPECT_NEAR(tracks[0].state.position.x(), 1190 + 2 * 90, 1e-9);
  EXPECT_NEAR(tracks[0].age, 2.0, 1e-9);
  EXPECT_FALSE(tracks[0].has_height);
  EXPECT_FALSE(tracks[0].covariance);
}

TEST(TrackPicture, ShowsConfirmedTracksOnly) {
  TrackPicture picture(30.0);
  tws_msgs::Tracks message = tracksAt(10, {firmTrack(1, 10, 0, 0), firmTrack(2, 10, 0, 0), firmTrack(3, 10, 0, 0)});
  message.tracks[1].state = Track::TENTATIVE;
  message.tracks[2].state = Track::COASTING;
  picture.add(message);
  EXPECT_EQ(picture.at(10.0).size(), 2U);
  message.tracks[0].state = Track::DROPPED;
  picture.add(message);
  ASSERT_EQ(picture.at(10.0).size(), 1U);
  EXPECT_EQ(picture.at(10.0)[0].id, 3U);
  EXPECT_TRUE(picture.at(41.0).empty());  // No update for more than 30 s.
}

TEST(TrackPicture, LeavesOutATrackThatIsNoNumber) {
  TrackPicture picture(30.0);
  tws_msgs::Track bad = firmTrack(1, 10, std::nan(""), 0);
  picture.add(tracksAt(10, {bad, firmTrack(2, 10, 0, 0)}));
  EXPECT_EQ(picture.at(10.0).size(), 1U);
  EXPECT_EQ(faultOf(bad), "position.x is nan");
  bad = firmTrack(1, 10, 0, 0);
  bad.state = 9;
  EXPECT_EQ(faultOf(bad), "state is 9");
}

TEST(TrackPicture, MovesTheCovarianceOnWithTheTrack) {
  TrackPicture picture(30.0);
  Track track = firmTrack(1, 10, 0, 0);
  track.covariance.assign(16, 0.0);
  for (const std::size_t i : {0, 5, 10, 15}) track.covariance[i] = 4.0;
  picture.add(tracksAt(10, {track}));
  const auto moved = picture.at(12.0).at(0).covariance;
  ASSERT_TRUE(moved);
  EXPECT_NEAR((*moved)(0, 0), 4.0 + 2.0 * 2.0 * 4.0, 1e-9);  // var x + t^2 var vx
  EXPECT_NEAR((*moved)(0, 2), 2.0 * 4.0, 1e-9);
}

}  // namespace
}  // namespace track_evaluation
