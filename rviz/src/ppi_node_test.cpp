#include <tws_rviz/ppi_node.h>

#include <gtest/gtest.h>
#include <tws_msgs/Detections.h>
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
  auto tracks = radar.advertise<tws_msgs::Tracks>("/adit/tracks");

  tws_msgs::Detections sector;
  sector.header.frame_id = "map";
  sector.detections.resize(3);
  sector.detections[1].range = NAN;
  detections.publish(sector);
  tws_msgs::SectorMark mark;
  mark.header.frame_id = "map";
  mark.sector = 200;
  marks.publish(mark);
  tws_msgs::Tracks lost;
  lost.header.frame_id = "nowhere";
  tracks.publish(lost);
  graph.drain();

  EXPECT_EQ(count(graph, "refused detections"), 1u);
  EXPECT_EQ(count(graph, "refused sector marks"), 1u);
  EXPECT_EQ(count(graph, "refused tracks"), 1u);
  EXPECT_NE(log.str().find("'nowhere'"), std::string::npos);
}

TEST(PpiNode, RefusesUnknownParameters) {
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  tws_runtime::Bus& bus = graph.addNode("ppi", YAML::Load("picture_rnage: 1000"));
  EXPECT_THROW(PpiNode node(bus), tws_runtime::ParameterError);
}

}  // namespace
}  // namespace tws_rviz
