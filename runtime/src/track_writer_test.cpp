#include <tws_runtime/track_writer.h>

#include <gtest/gtest.h>
#include <tws_core/angles.h>
#include <tws_core/geometry.h>
#include <tws_runtime/local_graph.h>

#include <cmath>
#include <sstream>
#include <vector>

namespace tws_runtime {
namespace {

TEST(TrackWriter, OfABlankTrackNothingIsKnown) {
  const tws_msgs::Track track = blankTrack(3, 7);
  EXPECT_EQ(track.number, 3u);
  EXPECT_EQ(track.uid, 7u);
  for (const double value : {track.elevation, track.position.z, track.velocity.z, track.height, track.height_sigma})
    EXPECT_TRUE(std::isnan(value));
  EXPECT_EQ(track.mode_3a, tws_msgs::Track::CODE_UNKNOWN);
}

// If these fail, `position.z` and `height` mean different things in different trackers' tracks.

// By hand, on a sphere of 6371 km from a radar on the sea: the sine of the elevation at which height h lies at range r
// is ((R + h)² − R² − r²) / (2·R·r), for 10 km at 200 km 0.034344; z = 6868.8 m, 3.13 km below the height.
TEST(TrackWriter, AHeightIsAboveTheSeaAndZAboveThePlane) {
  tws_msgs::Track track = blankTrack(1, 1);
  setAtHeight(track, {200e3, tws::kPi / 2.0, 100.0, 0.0}, 10e3, Site{}, tws::SeaLevel());
  EXPECT_EQ(track.height, 10e3);
  EXPECT_NEAR(track.position.z, 6868.8, 0.5);
  EXPECT_NEAR(track.elevation, std::asin(0.034344), 1e-6);
  EXPECT_NEAR(std::hypot(track.position.x, track.position.z), 200e3, 1e-6);
  tws_msgs::Track spatial = blankTrack(1, 1);
  tws::SpatialState state;
  state.mean << track.position.x, track.position.y, track.position.z, 0.0, 0.0, 0.0;
  setSpatial(spatial, state, Eigen::Vector3d::Zero(), tws::SeaLevel());
  EXPECT_NEAR(spatial.height, 10e3, 1e-3);
  EXPECT_NEAR(spatial.elevation, track.elevation, 1e-9);
  EXPECT_EQ(spatial.position.z, state.mean.z());
}

TEST(TrackWriter, WithoutAUsableHeightTheRangeIsLaidOnTheGround) {
  for (const double height : {std::nan(""), 5000.0}) {
    tws_msgs::Track track = blankTrack(1, 1);
    setAtHeight(track, {4000.0, 0.0, 50.0, 0.0}, height, Site{100.0, 200.0, 10.0, tws::kPi / 2.0}, tws::SeaLevel());
    EXPECT_NEAR(track.position.x, 100.0 - 4000.0, 1e-9) << "the site's north lies to the west";
    EXPECT_NEAR(track.position.y, 200.0, 1e-9);
    EXPECT_TRUE(std::isnan(track.position.z));
    EXPECT_TRUE(std::isnan(track.elevation));
    EXPECT_NEAR(track.course, 1.5 * tws::kPi, 1e-12);
    EXPECT_NEAR(track.speed, 50.0, 1e-9);
  }
}

TEST(TrackWriter, TheOriginCounts) {
  const YAML::Node tree = YAML::Load("{origin: {latitude_deg: 48, longitude_deg: 11, altitude_m: 500}}");
  ParameterReader reader(tree, "node");
  const tws::SeaLevel sea = readOrigin(reader);
  reader.done();
  EXPECT_NEAR(sea.heightOf({0.0, 0.0, 20.0}), 520.0, 1e-6);
  const YAML::Node half = YAML::Load("{origin: {latitude_deg: 48}}");
  ParameterReader wrong(half, "node");
  EXPECT_THROW(readOrigin(wrong), ParameterError);
}

TEST(TrackWriter, MessagesAreNumberedAndNameTheirSector) {
  std::ostringstream log;
  LocalGraph graph(log);
  Bus& bus = graph.addNode("tracker");
  std::vector<tws_msgs::Tracks> received;
  bus.subscribe<tws_msgs::Tracks>("/x/tracks", [&](const auto& message) { received.push_back(message); });
  TrackWriter writer(bus, "/x/tracks", "map");
  for (const std::int64_t running : {70, 71}) {
    tws_msgs::Tracks message = writer.message(12.5, "a", running);
    writer.publish(message);
  }
  graph.drain();
  ASSERT_EQ(received.size(), 2u);
  EXPECT_EQ(received[1].sequence, 1u);
  EXPECT_EQ(received[1].sector, 7u);
  EXPECT_EQ(received[1].running_sector, 71u);
  EXPECT_EQ(received[1].radar, "a");
  EXPECT_EQ(received[1].tracker, "tracker");
  EXPECT_EQ(received[1].header.frame_id, "map");
  EXPECT_EQ(received[1].header.stamp, ros::Time(12.5));
}

}  // namespace
}  // namespace tws_runtime
