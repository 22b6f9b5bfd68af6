#include "offline_graph.h"

#include <gtest/gtest.h>
#include <tws_runtime/parameters.h>

#include <sstream>

namespace tws_launch {
namespace {

// What the launch file says must be what runs offline, or nothing.

GraphDescription graphOf(const std::string& program) {
  const auto slash = program.find('/');
  return graphFromYaml("nodes: [{package: " + program.substr(0, slash) + ", type: " + program.substr(slash + 1) +
                       ", name: n, remaps: {/from: /to}, parameters: {radars: [{name: a}]}}]");
}

TEST(OfflineGraph, ReadsEveryPartOfANodesDescription) {
  const NodeDescription node = graphOf("adit_tracker/adit_node").nodes.at(0);
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
  const auto nodes = graphFromYaml(
      "nodes:\n- {package: track_correlator, type: ssr_tracker_node, name: s, remaps: {}, parameters: {radar: ssr}}\n"
      "- {package: track_correlator, type: track_correlator_node, name: c, remaps: {}, parameters: {clock_radar: "
      "ssr}}");
  std::ostringstream log;
  OfflineGraph offline(nodes, log);
  EXPECT_TRUE(offline.graph().isPublished("/ssr/tracks"));
  EXPECT_TRUE(offline.graph().isPublished("/correlated/tracks"));
}

TEST(OfflineGraph, MakesTheFrameBuilderAndTheTrackerOfFrames) {
  const auto nodes = graphFromYaml(
      "nodes:\n- {package: esa_frame_builder, type: frame_builder_node, name: f, remaps: {}, parameters: {radar: a}}\n"
      "- {package: esa_frame_builder, type: mfa_stub_node, name: m, remaps: {}, parameters: {radar: a}}");
  std::ostringstream log;
  OfflineGraph offline(nodes, log);
  for (const char* topic : {"/a/frames", "/a/tracks", "/a/track_database"})
    EXPECT_TRUE(offline.graph().isPublished(topic)) << topic;
}

TEST(OfflineGraph, PutsItsNodesIntoItsNamespace) {
  GraphDescription graph = graphOf("adit_tracker/adit_node");
  graph.space = "/ship";
  std::ostringstream log;
  OfflineGraph offline(graph, log);
  EXPECT_TRUE(offline.graph().isPublished("/ship/n/tracks"));
}

// A tracker of somebody else's runs offline by one row.
TEST(OfflineGraph, TakesFurtherRowsOfTheRegistry) {
  struct Silent {
    explicit Silent(tws_runtime::Bus& bus) { bus.counter("made").add(); }
  };
  NodeRegistry registry = nodeRegistry();
  registry.insert(nodeRow<Silent>("other/program"));
  std::ostringstream log;
  OfflineGraph offline(graphOf("other/program"), log, registry);
  EXPECT_EQ(offline.graph().counters().at(0).value, 1U);
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
