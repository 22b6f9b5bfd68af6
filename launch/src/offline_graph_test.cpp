#include "offline_graph.h"

#include <gtest/gtest.h>
#include <tws_runtime/parameters.h>

#include <sstream>

namespace tws_launch {
namespace {

// What the launch file says must be what runs offline, or nothing.

std::vector<NodeDescription> graphOf(const std::string& program) {
  const auto slash = program.find('/');
  return parseGraph("- {package: " + program.substr(0, slash) + ", type: " + program.substr(slash + 1) +
                    ", name: n, remaps: {/from: /to}, parameters: {radars: [{name: a}]}}");
}

TEST(OfflineGraph, ReadsEveryPartOfANodesDescription) {
  const NodeDescription node = graphOf("adit_tracker/adit_node").at(0);
  EXPECT_EQ(node.package, "adit_tracker");
  EXPECT_EQ(node.type, "adit_node");
  EXPECT_EQ(node.name, "n");
  EXPECT_EQ(node.remaps.at("/from"), "/to");
  EXPECT_EQ(node.parameters["radars"][0]["name"].as<std::string>(), "a");
}

TEST(OfflineGraph, MakesTheTrackerUnderItsName) {
  std::ostringstream log;
  OfflineGraph offline(graphOf("adit_tracker/adit_node"), log);
  EXPECT_TRUE(offline.graph().isPublished("/n/tracks"));
}

TEST(OfflineGraph, MakesTheSecondaryTrackerAndTheCorrelator) {
  const auto nodes = parseGraph(
      "- {package: track_correlator, type: ssr_tracker_node, name: s, remaps: {}, parameters: {radar: ssr}}\n"
      "- {package: track_correlator, type: track_correlator_node, name: c, remaps: {}, parameters: {clock_radar: "
      "ssr}}");
  std::ostringstream log;
  OfflineGraph offline(nodes, log);
  EXPECT_TRUE(offline.graph().isPublished("/ssr/tracks"));
  EXPECT_TRUE(offline.graph().isPublished("/correlated/tracks"));
}

TEST(OfflineGraph, MakesTheFrameBuilderAndTheTrackerOfFrames) {
  const auto nodes = parseGraph(
      "- {package: esa_frame_builder, type: frame_builder_node, name: f, remaps: {}, parameters: {radar: a}}\n"
      "- {package: esa_frame_builder, type: mfa_stub_node, name: m, remaps: {}, parameters: {radar: a}}");
  std::ostringstream log;
  OfflineGraph offline(nodes, log);
  for (const char* topic : {"/a/frames", "/a/tracks", "/a/track_database"})
    EXPECT_TRUE(offline.graph().isPublished(topic)) << topic;
}

TEST(OfflineGraph, LeavesOutWhatOnlyALiveGraphHas) {
  std::ostringstream log;
  for (const char* program : {"rosbag/record", "rosbag/play", "rviz/rviz", "tws_rviz/ppi_node"})
    EXPECT_TRUE(OfflineGraph(graphOf(program), log).sources().empty());
}

TEST(OfflineGraph, RefusesAProgramItDoesNotKnow) {
  std::ostringstream log;
  EXPECT_THROW(OfflineGraph(graphOf("other/program"), log), std::runtime_error);
}

TEST(OfflineGraph, PassesOnTheErrorOfANodesParameter) {
  std::ostringstream log;
  EXPECT_THROW(OfflineGraph(graphOf("radar_sim/radar_sim_node"), log), tws_runtime::ParameterError);
}

}  // namespace
}  // namespace tws_launch
