#include "graph_resolver.h"

#include <gtest/gtest.h>
#include <tf2_msgs/TFMessage.h>
#include <tws_msgs/OperatorRequest.h>
#include <tws_msgs/RangeProfile.h>
#include <tws_msgs/Tracks.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "input_test_helpers.h"
#include "run_plan.h"

namespace tws_launch {
namespace {

using Names = std::vector<std::string>;

// What runs follows from what is in the input. If one of these fails, a system that the input has is not tracked, or
// is tracked with the parameters of another.

const std::string kScenarios = TWS_LAUNCH_FOLDER "/scenarios/";

std::string text(const GraphDescription& graph, const std::string& node, const std::string& parameter) {
  const NodeDescription* found = graph.find(node);
  return found ? inOneLine(found->parameters[parameter]) : "no node";
}

TEST(GraphResolver, GivesTheFullScenarioEverySystem) {
  EXPECT_EQ(namesOf(graphOf(kScenarios + "full.yaml")),
            (Names{"radar_sim", "progress", "adit", "ssr_tracker", "track_correlator", "frame_builder", "mfa_stub",
                   "window_tracker", "range_gate_tracker", "evaluation"}));
}

TEST(GraphResolver, GivesEachScenarioWhatItsSensorsAskFor) {
  const std::map<std::string, Names> trackers{
      {"one_aircraft", {"adit"}},
      {"bel_three_targets", {"track_correlator"}},
      {"bel_dense", {"adit", "ssr_tracker", "track_correlator"}},
      {"esa_closely_spaced", {"frame_builder", "mfa_stub"}},
      {"mrs_ship", {"range_gate_tracker"}},
  };
  for (const auto& [name, expected] : trackers) {
    Names found;
    for (const NodeDescription& node : graphOf(kScenarios + name + ".yaml").nodes)
      if (node.role == "tracker") found.push_back(node.name);
    EXPECT_EQ(found, expected) << name;
  }
}

TEST(GraphResolver, ResolvesEveryScenario) {
  for (const auto& entry : std::filesystem::directory_iterator(kScenarios))
    EXPECT_GE(graphOf(entry.path()).nodes.size(), 4U) << entry.path();
}

// Users copy scenarios, as the README tells them. A ship is tracked with a window of 100 m, an aircraft with 24 m.
TEST(GraphResolver, TakesParametersFromAScenariosContentNotFromItsName) {
  const TemporaryFolder folder;
  std::filesystem::copy_file(kScenarios + "mrs_ship.yaml", folder.file("mine.yaml"));
  EXPECT_EQ(text(graphOf(folder.file("mine.yaml")), "range_gate_tracker", "window_m"), "100.0");
  std::filesystem::copy_file(kScenarios + "mrs_aircraft.yaml", folder.file("mrs_ship.yaml"));
  EXPECT_EQ(text(graphOf(folder.file("mrs_ship.yaml")), "range_gate_tracker", "window_m"), "24.0");
}

// If this fails, a file below /data/$day cannot be run.
TEST(GraphResolver, TakesNoPathForAWord) {
  const TemporaryFolder folder;
  const std::string mine = folder.file("a$HOME $name.yaml");
  std::filesystem::copy_file(kScenarios + "full.yaml", mine);
  const GraphDescription graph = graphOf(mine, options({{"record", "/$each.rotating/$x.bag"}, {"rate", "1"}}), true);
  EXPECT_EQ(text(graph, "radar_sim", "scenario"), '"' + mine + '"');
  const NodeDescription* recorder = graph.find("recorder");
  ASSERT_TRUE(recorder);
  EXPECT_EQ(std::count(recorder->arguments.begin(), recorder->arguments.end(), "--output-name=/$each.rotating/$x.bag"),
            1);
}

TEST(GraphResolver, LetsAPersonChangeWhatAScenarioSays) {
  const std::string full = kScenarios + "full.yaml";
  const auto with = [&](const std::string& name, const std::string& value) {
    return graphOf(full, options({{name, value}}));
  };
  EXPECT_EQ(text(with("params", "nrl7952"), "adit", "set"), "\"nrl7952\"");
  EXPECT_EQ(text(with("params", "range_gate_tracker=ship"), "range_gate_tracker", "window_m"), "100.0");
  EXPECT_EQ(text(with("trackers", "{window_tracker: {radar: sps39}}"), "window_tracker", "radar"), "\"sps39\"");
  EXPECT_FALSE(with("trackers", "{window_tracker: off}").find("window_tracker"));
  EXPECT_TRUE(graphOf(kScenarios + "one_aircraft.yaml", options({{"trackers", "{window_tracker: on}"}}))
                  .find("window_tracker"));
}

// Two trackers side by side on the same radars.
TEST(GraphResolver, RunsASecondTrackerLikeAnother) {
  const GraphDescription graph =
      graphOf(kScenarios + "one_aircraft.yaml", options({{"trackers", "{second: {like: adit, params: nrl7952}}"}}));
  EXPECT_EQ(text(graph, "adit", "set"), "\"default\"");
  EXPECT_EQ(text(graph, "second", "set"), "\"nrl7952\"");
  EXPECT_EQ(text(graph, "evaluation", "trackers"), "[\"adit\", \"second\"]");
}

TEST(GraphResolver, RefusesChoicesOfNodesThatAreNotThere) {
  const auto refusal = [](const std::string& trackers) {
    return reasonOf([&] { graphOf(kScenarios + "one_aircraft.yaml", options({{"trackers", trackers}})); });
  };
  EXPECT_NE(refusal("{adlt: on}").find("there is no node 'adlt' (nodes: adit"), std::string::npos);
  EXPECT_NE(refusal("{range_gate_tracker: ship}").find("range_gate_tracker is no part"), std::string::npos);
}

// A slip of the pen is answered with what could have been meant.
TEST(GraphResolver, RefusesAParameterSetThatIsNotThere) {
  const std::string one = kScenarios + "one_aircraft.yaml";
  EXPECT_EQ(reasonOf([&] {
              graphOf(one, options({{"params", "nosuch"}}));
            }),
            "adit: there is no parameter set 'nosuch' (adit_tracker/config: airport approach default marine nrl7952)");
  EXPECT_THROW(graphOf(one, options({{"params", "nosuch"}})), UsageError);
  const TemporaryFolder folder;
  std::ofstream(folder.file("mine.yaml")) << std::ifstream(one).rdbuf() << "\ntrackers: {adit: nosuch}\n";
  EXPECT_EQ(
      reasonOf([&] { graphOf(folder.file("mine.yaml")); }).find(folder.file("mine.yaml") + ": trackers: adit: there"),
      0U);
}

// ---- bags ----

/// A bag of a range radar, with the description of a graph.
void writeRangeBag(const std::string& path, const std::string& description) {
  BagUnderTest bag(path);
  if (!description.empty()) {
    tws_msgs::GraphDescription message;
    message.yaml = description;
    bag.with("/graph", message);
  }
  bag.with("/mrs/range_profile", of<tws_msgs::RangeProfile>("mrs")).close();
}

// A bag may be moved and renamed. If this fails, a replay does not give the tracks that were recorded.
TEST(GraphResolver, ReplaysABagWithTheParametersItWasRecordedWith) {
  const TemporaryFolder folder;
  const std::string bag = folder.file("some.bag");
  writeRangeBag(bag, toYaml(graphOf(kScenarios + "mrs_ship.yaml")));
  EXPECT_EQ(text(graphOf(bag), "range_gate_tracker", "window_m"), "100.0");
  EXPECT_EQ(text(graphOf(bag, options({{"params", "range_gate_tracker=aircraft"}})), "range_gate_tracker", "window_m"),
            "24.0");
  writeRangeBag(bag, "");
  EXPECT_EQ(text(graphOf(bag), "range_gate_tracker", "window_m"), "24.0");
}

TEST(GraphResolver, ReplaysOnlyTheTrackersThatRan) {
  const TemporaryFolder folder;
  const std::string bag = folder.file("some.bag");
  const RunOptions without = options({{"trackers", "{range_gate_tracker: off}"}});
  writeRangeBag(bag, toYaml(graphOf(kScenarios + "mrs_ship.yaml", without)));
  EXPECT_FALSE(graphOf(bag).find("range_gate_tracker"));
  EXPECT_TRUE(graphOf(bag, options({{"trackers", "{range_gate_tracker: on}"}})).find("range_gate_tracker"));
}

TEST(GraphResolver, RefusesADescriptionThatIsNone) {
  const TemporaryFolder folder;
  writeRangeBag(folder.file("some.bag"), "nodes: [{name: ]");
  EXPECT_NE(reasonOf([&] { graphOf(folder.file("some.bag")); }).find("is no description of a graph"),
            std::string::npos);
}

// Bags from before descriptions: what they hold tells that the window tracker ran, and on which radar.
TEST(GraphResolver, KnowsTheWindowTrackerOfAnOldBagByItsTracks) {
  const TemporaryFolder folder;
  BagUnderTest(folder.file("old.bag"))
      .withRadar("/", "sps12")
      .withRadar("/", "sps39")
      .with("/tws/tracks", of<tws_msgs::Tracks>("sps39"))
      .close();
  EXPECT_EQ(text(graphOf(folder.file("old.bag")), "window_tracker", "radar"), "\"sps39\"");
}

/// For how many subscribers of the topic a source waits.
long awaited(const GraphDescription& graph, const std::string& source, const std::string& topic) {
  const auto list = graph.find(source)->parameters["live"]["wait_for"].as<Names>();
  return std::count(list.begin(), list.end(), topic);
}

// If the count is wrong, a run starts before all have connected, and its first scan is lost, or it waits in vain.
TEST(GraphResolver, WaitsForEveryNodeThatHearsTheSource) {
  const auto count = [](const GraphDescription& graph, const std::string& topic) {
    return awaited(graph, "radar_sim", topic);
  };
  const std::string one = kScenarios + "one_aircraft.yaml";
  EXPECT_EQ(count(graphOf(one, {}, true), "/sps12/detections"), 3);  // ADIT, progress, evaluation
  EXPECT_EQ(count(graphOf(one, options({{"record", "r.bag"}, {"rviz", "true"}}), true), "/sps12/detections"), 5);
  EXPECT_EQ(count(graphOf(one, options({{"record", "r.bag"}}), true), "/truth"), 2);
  EXPECT_EQ(count(graphOf(kScenarios + "full.yaml", {}, true), "/sps12/detections"), 4);  // the window tracker, too
}

// If this fails, the recording lacks the trackers' first words where the recorder is connected to them late.
TEST(GraphResolver, WaitsForEveryNodeThatHearsATracker) {
  const std::string full = kScenarios + "full.yaml";
  const auto count = [](const GraphDescription& graph, const std::string& topic) {
    return awaited(graph, "radar_sim", topic);
  };
  EXPECT_EQ(count(graphOf(full, {}, true), "/tws/tracks"), 2);  // progress, evaluation
  const GraphDescription recorded = graphOf(full, options({{"record", "r.bag"}}), true);
  EXPECT_EQ(count(recorded, "/tws/tracks"), 3);
  EXPECT_EQ(count(recorded, "/adit/tracks"), 4);               // the correlator, too
  EXPECT_EQ(count(recorded, "/diagnostics"), 0);               // of each node's own
  EXPECT_EQ(count(recorded, "/sps39/elevation_requests"), 0);  // perhaps nobody's
}

TEST(GraphResolver, APlayerIsHeldBackForTheTrackersListenersAlone) {
  const TemporaryFolder folder;
  BagUnderTest(folder.file("run.bag")).withRadar("/ship1/", "sps12").close();
  const GraphDescription graph = graphOf(folder.file("run.bag"), options({{"record", "r.bag"}}), true);
  EXPECT_EQ(awaited(graph, "player", "/ship1/adit/tracks"), 3);  // progress, evaluation, recorder
  EXPECT_EQ(awaited(graph, "player", "/ship1/sps12/detections"), 0);
  EXPECT_NE(graph.find("player")->prefix.find("wait_for_subscribers"), std::string::npos);
}

TEST(GraphResolver, PlaysOnlyWhatIsHeardAsItIsRecorded) {
  const TemporaryFolder folder;
  BagUnderTest(folder.file("run.bag"))
      .withRadar("", "sps12")
      .with("adit/tracks", tws_msgs::Tracks())
      .with("/other/tracks", tws_msgs::Tracks())
      .with("/diagnostics", tws_msgs::Tracks())
      .close();
  const GraphDescription graph = graphOf(folder.file("run.bag"), options({{"record", "r.bag"}}), true);
  const std::vector<std::string>& arguments = graph.find("player")->arguments;
  const auto topics = std::find(arguments.begin(), arguments.end(), "--topics");
  EXPECT_EQ(Names(topics + 1, arguments.end()), (Names{"sps12/detections", "sps12/sector_marks"}));
}

// If this fails, a recording made on a ship is replayed without the ship's place, or a player waits for ever until
// somebody hears it.
TEST(GraphResolver, PlaysAndRecordsWhereOwnShipIsWhereATrackerFollowsIt) {
  const TemporaryFolder folder;
  BagUnderTest(folder.file("run.bag")).withRadar("", "sps12").with("/tf", tf2_msgs::TFMessage()).close();
  std::ofstream(folder.file("ship.yaml")) << "own_ship_frame: ship\n";
  const auto plays = [&](const RunOptions& chosen) {
    const GraphDescription graph = graphOf(folder.file("run.bag"), chosen, true);
    const std::vector<std::string>& played = graph.find("player")->arguments;
    return std::count(played.begin(), played.end(), "/tf");
  };
  EXPECT_EQ(plays({}), 0);
  EXPECT_EQ(plays(options({{"record", "r.bag"}})), 1) << "the recorder hears it";
  EXPECT_EQ(plays(options({{"params", "adit=" + folder.file("ship.yaml")}})), 1);
}

TEST(GraphResolver, MovesTheGraphIntoTheNamespaceOfItsBag) {
  const TemporaryFolder folder;
  BagUnderTest(folder.file("run.bag")).withRadar("/ship1/", "sps12").close();
  const GraphDescription graph = graphOf(folder.file("run.bag"), options({{"record", "r.bag"}}), true);
  EXPECT_EQ(graph.space, "/ship1");
  const std::vector<std::string>& recorded = graph.find("recorder")->arguments;
  EXPECT_EQ(std::count(recorded.begin(), recorded.end(), "/ship1/adit/tracks"), 1);
  EXPECT_EQ(graph.find("player")->remaps.at("/ship1/clock"), "/clock");  // Else nobody there knows what time it is.
}

// If this fails, a second tracker is replayed live without what its operators asked.
TEST(GraphResolver, HandsRecordedRequestsToEveryTrackerThatRepeatsThem) {
  const TemporaryFolder folder;
  BagUnderTest(folder.file("run.bag"))
      .withRadar("/ship1/", "sps12")
      .with("/ship1/tws/operator_requests", tws_msgs::OperatorRequest())  // as it was called before
      .close();
  const RunOptions chosen = options({{"trackers", "{second: {like: adit}, window_tracker: on}"}});
  EXPECT_EQ(graphOf(folder.file("run.bag"), chosen, true).find("operator_player")->remaps,
            (std::map<std::string, std::string>{
                {"/ship1/adit/operator_requests", "/ship1/adit/recorded_requests"},
                {"/ship1/second/operator_requests", "/ship1/second/recorded_requests"},
                {"/ship1/tws/operator_requests", "/ship1/window_tracker/recorded_requests"}}));
}

}  // namespace
}  // namespace tws_launch
