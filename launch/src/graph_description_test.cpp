#include "graph_description.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace tws_launch {
namespace {

// A bag carries this text. If it does not read back as it was, a replay has other parameters than the run.
TEST(GraphDescription, ReadsBackWhatItWrote) {
  GraphDescription graph;
  graph.space = "/ship";
  graph.sensors = {{"rotating", {"sps12", "a b"}}};
  graph.remaps = {{"/ship/x", "/y"}};
  NodeDescription node;
  node.package = "p";
  node.type = "t";
  node.name = "n";
  node.role = "tracker";
  node.remaps = {{"/ship/from", "/ship/to"}};
  node.parameters = YAML::Load("{a: 1, b: [1.5, 1e6, off], c: {d: \"2020-01-01\", e: ''}, f: \"say \\\"x\\\": {y}\"}");
  graph.nodes = {node};
  const GraphDescription read = graphFromYaml(toYaml(graph));
  EXPECT_EQ(toYaml(read), toYaml(graph));
  EXPECT_EQ(read.sensors, graph.sensors);
  EXPECT_EQ(read.nodes.at(0).remaps, node.remaps);
  EXPECT_EQ(read.nodes.at(0).parameters["f"].as<std::string>(), "say \"x\": {y}");
}

// rosparam reads YAML 1.1, where off is false, 012 is ten and 12:30 is 750.
TEST(GraphDescription, QuotesWhatReadersOfYamlTakeForDifferentThings) {
  for (const char* bare : {"true", "-12", "1.5", "1.0e-10", "0"}) EXPECT_EQ(inOneLine(YAML::Load(bare)), bare);
  for (const char* other : {"off", "yes", "012", "1e6", "12:30", "0x10", "2020-01-01", "12345678901", "~x"})
    EXPECT_EQ(inOneLine(YAML::Load(other)), "\"" + std::string(other) + "\"");
  EXPECT_EQ(inOneLine(YAML::Load("'12'")), "\"12\"");
}

TEST(GraphDescription, RefusesWhatIsNone) {
  for (const char* text : {"nodes: [{name: n}]", "nodes: [", "sensors: 3"})
    EXPECT_THROW(graphFromYaml(text), std::runtime_error) << text;
}

}  // namespace
}  // namespace tws_launch
