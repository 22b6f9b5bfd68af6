#include <tws_rviz/ppi_node.h>

#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>
#include <tws_msgs/Detections.h>
#include <tws_msgs/RadarMap.h>
#include <tws_msgs/Registration.h>
#include <tws_msgs/SectorMark.h>
#include <tws_msgs/Tracks.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/parameters.h>
#include <visualization_msgs/MarkerArray.h>

#include <cmath>
#include <sstream>

namespace tws_rviz {
namespace {

std::uint64_t count(const tws_runtime::LocalGraph& graph, const std::string& name) {
  for (const tws_runtime::CounterReading& reading : graph.counters())
    if (reading.name == name) return reading.value;
  return 0;
}

// The fixed picture is there for an RViz that starts later than the node.
TEST(PpiNode, PublishesTheBackgroundForLateSubscribers) {
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  PpiNode node(graph.addNode("ppi"));
  graph.drain();
  std::size_t markers = 0;
  graph.addNode("rviz").subscribe<visualization_msgs::MarkerArray>(
      "/ppi/background", [&](const visualization_msgs::MarkerArray& array) { markers = array.markers.size(); });
  graph.drain();
  EXPECT_GT(markers, 12u);
}

// A fault upstream is said and counted; the rest of the picture goes on.
TEST(PpiNode, CountsBadInputAndGoesOn) {
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  PpiNode node(graph.addNode("ppi"));
  tws_runtime::Bus& radar = graph.addNode("radar");
  auto detections = radar.advertise<tws_msgs::Detections>("/sps12/detections");
  auto marks = radar.advertise<tws_msgs::SectorMark>("/sps12/sector_marks");

  tws_msgs::Detections sector;
  sector.header.frame_id = "map";
  sector.detections.resize(3);
  sector.detections[1].range = NAN;
  detections.publish(sector);
  tws_msgs::SectorMark mark;
  mark.header.frame_id = "map";
  mark.sector = 200;
  marks.publish(mark);
  tws_msgs::RadarMap map;
  map.header.frame_id = "map";
  map.radar = "sps12";
  map.depth = 1e3;
  map.bins = 2;
  map.false_plots.resize(128);
  auto maps = radar.advertise<tws_msgs::RadarMap>("/adit/radar_maps");
  maps.publish(map);  // Without `blind`.
  map.blind.resize(128);
  maps.publish(map);
  map.radar = "nosuch";
  maps.publish(map);
  tws_msgs::Registration registration;
  registration.radars.resize(2);
  registration.radars[0].radar = "sps12";
  registration.radars[1].radar = "nosuch";
  radar.advertise<tws_msgs::Registration>("/adit/registration").publish(registration);
  graph.drain();

  EXPECT_EQ(count(graph, "refused registrations"), 1u);
  EXPECT_EQ(count(graph, "refused detections"), 1u);
  EXPECT_EQ(count(graph, "refused sector marks"), 1u);
  EXPECT_EQ(count(graph, "refused radar maps"), 2u);
}

// If this fails, one stamp that was damaged on its way clears the picture, or removes a radar from then on.
TEST(PpiNode, AStrayStampIsLeftOut) {
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  PpiNode node(graph.addNode("ppi"));
  auto tracks = graph.addNode("adit").advertise<tws_msgs::Tracks>("/adit/tracks");
  tws_msgs::Tracks message;
  message.header.frame_id = "map";
  const auto say = [&](double time) {
    message.header.stamp = ros::Time(time);
    tracks.publish(message);
    graph.drain();
  };
  for (const double stray : {86500.0, 0.0}) {
    say(100.0);
    say(stray);
    say(100.1);
  }
  EXPECT_EQ(count(graph, "stray messages"), 2u);
  EXPECT_EQ(count(graph, "new runs"), 0u);
  for (double time = 1.0; time < 3.0; time += 0.1) say(time);
  EXPECT_EQ(count(graph, "new runs"), 1u);
}

// At the start, detections overtake the transform of their site; that alone is no fault. Without one at all nothing can
// be drawn, and the operator must be told why.
TEST(PpiNode, AMissingTransformIsAFaultOnlyWhenItStaysAway) {
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  PpiNode node(graph.addNode("ppi"));
  auto tracks = graph.addNode("adit").advertise<tws_msgs::Tracks>("/adit/tracks");
  tws_msgs::Tracks lost;
  lost.header.frame_id = "nowhere";
  for (const double time : {100.0, 104.0}) {
    lost.header.stamp = ros::Time(time);
    tracks.publish(lost);
  }
  graph.drain();
  EXPECT_EQ(count(graph, "refused tracks"), 0u);
  EXPECT_EQ(count(graph, "messages before their site's transform"), 2u);

  lost.header.stamp = ros::Time(106.0);
  tracks.publish(lost);
  graph.drain();
  EXPECT_EQ(count(graph, "refused tracks"), 1u);
  EXPECT_NE(log.str().find("'nowhere'"), std::string::npos);
}

// If this fails, the plots of a ship's radar are not drawn, as its frame is on /tf alone.
TEST(PpiNode, ARadarOnAShipIsDrawnWhereTheShipIs) {
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  PpiNode node(graph.addNode("ppi"));
  tws_runtime::Bus& ship = graph.addNode("ship");
  auto poses = ship.advertise<tf2_msgs::TFMessage>("/tf");
  auto detections = ship.advertise<tws_msgs::Detections>("/sps12/detections");
  tf2_msgs::TFMessage pose;
  pose.transforms.resize(1);
  pose.transforms[0].header.stamp = ros::Time(100.0);
  pose.transforms[0].header.frame_id = "map";
  pose.transforms[0].child_frame_id = "sps12";
  pose.transforms[0].transform.rotation.w = 1.0;
  poses.publish(pose);
  tws_msgs::Detections sector;
  sector.header.stamp = ros::Time(100.3);
  sector.header.frame_id = "sps12";
  detections.publish(sector);
  graph.drain();
  EXPECT_EQ(count(graph, "messages before their site's transform"), 0u);
  EXPECT_EQ(log.str(), "");
}

TEST(PpiNode, RefusesUnknownParameters) {
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  tws_runtime::Bus& bus = graph.addNode("ppi", YAML::Load("picture_rnage: 1000"));
  EXPECT_THROW(PpiNode node(bus), tws_runtime::ParameterError);
}

}  // namespace
}  // namespace tws_rviz
