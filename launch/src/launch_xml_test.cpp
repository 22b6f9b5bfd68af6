#include "launch_xml.h"

#include <gtest/gtest.h>

namespace tws_launch {
namespace {

NodeDescription node(const std::string& role) {
  NodeDescription node;
  node.package = "p";
  node.type = "t";
  node.name = "n";
  node.role = role;
  return node;
}

std::string xmlOf(const NodeDescription& node) {
  GraphDescription graph;
  graph.nodes = {node};
  return launchXml(graph);
}

bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(LaunchXml, EndsTheRunWithASourceOrATrackerUnlessThatIsStartedAgain) {
  EXPECT_TRUE(holds(xmlOf(node("tracker")), "required=\"true\""));
  EXPECT_FALSE(holds(xmlOf(node("watcher")), "required"));
  // A run that nobody records is not what was asked for.
  EXPECT_TRUE(holds(xmlOf(node("recorder")), "required=\"true\""));
  NodeDescription again = node("tracker");
  again.respawn = true;
  EXPECT_FALSE(holds(xmlOf(again), "required"));
  EXPECT_TRUE(holds(xmlOf(again), "respawn=\"true\""));
}

// If this fails, a path with a blank or an ampersand in it makes roslaunch fail.
TEST(LaunchXml, QuotesForTheShellAndForXml) {
  NodeDescription player = node("source");
  player.arguments = {"--rate=1", "/my runs/a&b.bag"};
  player.parameters["text"] = "x < \"y\"";
  const std::string xml = xmlOf(player);
  EXPECT_TRUE(holds(xml, "args=\"--rate=1 '/my runs/a&amp;b.bag'\"")) << xml;
  EXPECT_TRUE(holds(xml, "\"text\": &quot;x &lt; \\&quot;y\\&quot;&quot;") || holds(xml, "x &lt; ")) << xml;
}

// If this fails, an apostrophe in the name of a folder breaks the recorder's line, and a new line becomes a space.
TEST(LaunchXml, NamesComeThroughShellAndXmlAsTheyAre) {
  NodeDescription recorder = node("recorder");
  recorder.arguments = {"/it's", "/two\nlines", "/März", "/a\"b", "-x"};
  const std::string xml = xmlOf(recorder);
  EXPECT_TRUE(holds(xml, "args=\"'/it'&quot;'&quot;'s' '/two&#10;lines' '/März' '/a&quot;b' -x\"")) << xml;
  recorder.arguments = {"/$(arg x)/run.bag"};
  EXPECT_THROW(xmlOf(recorder), std::runtime_error);
}

// If this fails, the end of the scenario does not end the run, or a user's own program is loaded as a nodelet.
TEST(LaunchXml, LoadsNodesAsNodeletsOfOneManagerWhenAsked) {
  GraphDescription graph;
  graph.nodelets = true;
  graph.nodes = {node("source"), node("watcher")};
  graph.nodes[0].type = "radar_sim_node";
  const std::string xml = launchXml(graph);
  EXPECT_TRUE(holds(xml, "args=\"manager\" output=\"screen\" required=\"true\" name=\"manager\"")) << xml;
  EXPECT_TRUE(holds(xml, "args=\"load p/radar_sim_nodelet manager\"")) << xml;
  EXPECT_TRUE(holds(xml, "<param name=\"live/required\" value=\"true\"/>")) << xml;
  EXPECT_TRUE(holds(xml, "pkg=\"p\" type=\"t\"")) << xml;
}

TEST(LaunchXml, PutsTheGraphIntoItsNamespaceWithItsRemaps) {
  GraphDescription graph;
  graph.space = "/ship";
  graph.remaps = {{"/ship/sps12/detections", "/north/plots"}};
  graph.nodes = {node("tracker")};
  const std::string xml = launchXml(graph);
  EXPECT_TRUE(holds(xml, "<group ns=\"/ship\">"));
  EXPECT_TRUE(holds(xml, "<remap from=\"/ship/sps12/detections\" to=\"/north/plots\"/>"));
}

}  // namespace
}  // namespace tws_launch
