// The node in one process: its clutter map saved and loaded.
#include <gtest/gtest.h>
#include <tws_msgs/ClutterMap.h>
#include <tws_msgs/LoadClutterMap.h>
#include <tws_msgs/SaveClutterMap.h>
#include <tws_runtime/parameters.h>

#include <filesystem>
#include <fstream>

#include <tws_core/temporary_folder_test_helpers.h>

#include "adit_node_test_helpers.h"

namespace adit_tracker {
namespace {

using Request = tws_msgs::OperatorRequest;

/// A file of its own, gone afterwards.
class ClutterInterfaceTest : public testing::Test {
 protected:
  static tws_msgs::SaveClutterMap::Response save(NodeGraph& node, const std::string& path) {
    tws_msgs::SaveClutterMap::Request request;
    tws_msgs::SaveClutterMap::Response answer;
    request.path = path;
    node.graph.call<tws_msgs::SaveClutterMap>("/adit/save_clutter_map", request, answer);
    return answer;
  }

  static tws_msgs::LoadClutterMap::Response load(NodeGraph& node, const std::string& path) {
    tws_msgs::LoadClutterMap::Request request;
    tws_msgs::LoadClutterMap::Response answer;
    request.path = path;
    node.graph.call<tws_msgs::LoadClutterMap>("/adit/load_clutter_map", request, answer);
    return answer;
  }

  /// Where the first aircraft flies from 52 s on.
  static std::string pointsInItsWay() {
    std::ostringstream lines;
    const TestTarget aircraft = eightAircraft()[0];
    for (double t = 52.0; t < 64.5; t += 1.0)
      lines << "*," << aircraft.range(t) << ',' << tws::degrees(aircraft.azimuth(t)) << '\n';
    return lines.str();
  }

  void write(const std::string& lines) const { std::ofstream(path_) << "radar,range_m,az_deg\n" << lines; }

  /// Aircraft and ten rocks.
  static RadarSectors scene(double to) {
    std::vector<TestTarget> targets = eightAircraft();
    for (int i = 0; i < 10; ++i) targets.push_back({-15e3 - 1.5e3 * i, 3e3 * i, 0.0, 0.0});
    return flights(to, targets);
  }

  /// Loads the map in mid-run.
  void fly(NodeGraph& node, const RadarSectors& radars) const {
    node.play(radars, 0.0, 40.0);
    EXPECT_EQ(load(node, "map.csv").message, "13 points loaded from " + path_);
    node.play(radars, 40.0, 120.0);
  }

  const tws::TemporaryFolder temporary_;
  const std::filesystem::path folder_ = temporary_.path();
  const std::string path_ = folder_ / "map.csv";
  const std::string in_folder_ = "clutter_map_folder: " + folder_.string();
  const std::string with_file_ = "{clutter_map: " + path_ + "}";
};

// If this fails, a map that was learned is lost with the run.
TEST_F(ClutterInterfaceTest, WhatIsSavedInOneRunIsThereInTheNextFromTheStart) {
  const RadarSectors radars = scene(100.0);
  NodeGraph first("{" + in_folder_ + "}");
  first.play(radars, 0.0, 100.0);
  const auto saved = save(first, "map.csv");
  EXPECT_TRUE(saved.success);
  EXPECT_EQ(saved.message, std::to_string(saved.count) + " points and the maps of 2 radars saved to " + path_);
  EXPECT_GE(saved.count, 20U);
  NodeGraph second(with_file_);
  second.play(radars, 0.0, 30.0);
  NodeGraph bare;
  bare.play(radars, 0.0, 30.0);
  const auto tracks_begun = [](const NodeGraph& node) {
    std::set<std::uint32_t> uids;
    for (const auto& update : node.updates()) uids.insert(update.uid);
    return uids.size();
  };
  EXPECT_GE(tracks_begun(bare), tracks_begun(second) + 8);
  ASSERT_FALSE(second.told.empty());
  EXPECT_EQ(second.told[0].request, Request::LOAD_CLUTTER);
  EXPECT_EQ(second.told[0].clutter.size(), saved.count);
  EXPECT_EQ(second.told[0].radar_counts.size(), 2U);
  EXPECT_EQ(second.told[0].radar, "");
  EXPECT_EQ(second.told[0].result, Request::OK);
}

// If this fails, a replay goes another way than the run, or needs a file that may be gone.
TEST_F(ClutterInterfaceTest, AReplayRepeatsALoadWithoutTheFileByteByByte) {
  const RadarSectors radars = scene(120.0);
  for (const char* set : {"default", "nrl7952"}) {
    write(pointsInItsWay());
    const std::string given = std::string("{set: ") + set + ", " + in_folder_ + "}";
    NodeGraph run(given), replay(given), idle(given);
    fly(run, radars);
    std::filesystem::remove(path_);
    ASSERT_EQ(run.told.size(), 1U);
    EXPECT_EQ(run.told[0].clutter.size(), 13U);
    EXPECT_EQ(run.told[0].count, 13U);
    replay.recorded.publish(run.told[0]);
    replay.play(radars, 0.0, 120.0);
    idle.play(radars, 0.0, 120.0);
    EXPECT_TRUE(NodeGraph::bytesOf(replay.tracks) == NodeGraph::bytesOf(run.tracks)) << set;
    EXPECT_TRUE(NodeGraph::bytesOf(replay.told) == NodeGraph::bytesOf(run.told)) << set;
    EXPECT_TRUE(NodeGraph::bytesOf(idle.tracks) != NodeGraph::bytesOf(run.tracks)) << "the map changed nothing";
    EXPECT_EQ(replay.count("late recorded requests") + replay.count("requests repeated with another effect"), 0U);
  }
}

TEST_F(ClutterInterfaceTest, AReplayRepeatsTheMapThatTheRunBeganWith) {
  const RadarSectors radars = scene(60.0);
  write("*,21000,280\n*,22500,278\n");
  NodeGraph run(with_file_);
  run.play(radars, 0.0, 60.0);
  ASSERT_EQ(run.told.size(), 1U);
  NodeGraph again(with_file_);  // told by the recording and by the parameter
  std::filesystem::remove(path_);
  NodeGraph replay;
  for (NodeGraph* node : {&again, &replay}) {
    node->recorded.publish(run.told[0]);
    node->play(radars, 0.0, 60.0);
    EXPECT_TRUE(NodeGraph::bytesOf(node->tracks) == NodeGraph::bytesOf(run.tracks));
    EXPECT_TRUE(NodeGraph::bytesOf(node->told) == NodeGraph::bytesOf(run.told));
    EXPECT_EQ(node->count("late recorded requests"), 0U);
  }
  NodeGraph late;
  late.play(radars, 0.0, 10.0);
  late.recorded.publish(run.told[0]);
  late.play(radars, 10.0, 60.0);
  EXPECT_EQ(late.count("late recorded requests"), 1U);
}

// If this fails, a replay lacks what the run knew of its radars.
TEST_F(ClutterInterfaceTest, AReplayRepeatsWhatWasLearnedOfTheRadars) {
  const RadarSectors radars = scene(100.0);
  NodeGraph first("{" + in_folder_ + "}");
  first.play(radars, 0.0, 100.0);
  save(first, "map.csv");
  NodeGraph run(with_file_);
  run.play(radars, 0.0, 60.0);
  ASSERT_EQ(run.told.size(), 1U);
  NodeGraph again(with_file_);  // told by the recording and by the parameter
  std::filesystem::remove(path_);
  NodeGraph replay, points;
  Request without = run.told[0];
  without.radar_counts.clear();
  points.recorded.publish(without);
  for (NodeGraph* node : {&again, &replay}) node->recorded.publish(run.told[0]);
  for (NodeGraph* node : {&again, &replay, &points}) node->play(radars, 0.0, 60.0);
  for (NodeGraph* node : {&again, &replay}) {
    EXPECT_TRUE(NodeGraph::bytesOf(node->tracks) == NodeGraph::bytesOf(run.tracks));
    EXPECT_TRUE(NodeGraph::bytesOf(node->told) == NodeGraph::bytesOf(run.told));
  }
  EXPECT_TRUE(NodeGraph::bytesOf(points.tracks) != NodeGraph::bytesOf(run.tracks)) << "it changed nothing";
}

TEST_F(ClutterInterfaceTest, ANewRunBeginsWithTheMapAgain) {
  write("*,30000,300\n");
  const RadarSectors radars = scene(30.0);
  NodeGraph node(with_file_);
  node.play(radars, 0.0, 30.0);
  node.play(radars, 0.0, 30.0);
  ASSERT_EQ(node.told.size(), 2U);
  EXPECT_EQ(node.told[1].run, 1U);
  EXPECT_EQ(node.told[1].clutter.size(), 1U);
}

// Nothing of the first run has been processed: it takes five sectors of both radars.
TEST_F(ClutterInterfaceTest, ARunThatBeginsAgainBeforeItsFirstSectorHasTheMapToo) {
  write("*,30000,300\n");
  const RadarSectors radars = scene(41.0);
  NodeGraph node(with_file_);
  node.play(radars, 40.0, 40.3);
  ASSERT_TRUE(node.tracks.empty());
  node.play(radars, 0.0, 30.0);
  ASSERT_EQ(node.told.size(), 1U);
  EXPECT_EQ(node.told[0].run, 1U);
  EXPECT_EQ(node.told[0].count, 1U);
  EXPECT_EQ(node.told[0].result, Request::OK);
}

// If this fails, an operator whose file was not loaded does not know it, or a bag does not.
TEST_F(ClutterInterfaceTest, AMapThatCannotBeLoadedOrSavedIsRefusedInWordsAndTheRefusalRepeated) {
  const RadarSectors radars = scene(60.0);
  NodeGraph node("{" + in_folder_ + "}"), replay;
  EXPECT_EQ(save(node, "map.csv").message, "no sector has been processed yet");
  write("*,1000,1\n");
  EXPECT_EQ(load(node, "map.csv").message, "busy: no sector has been processed yet");
  EXPECT_EQ(node.told.back().result, Request::BUSY);
  node.play(radars, 0.0, 30.0);
  write("*,1000,1\n*,-5,1\n");
  const auto answer = load(node, "map.csv");
  EXPECT_FALSE(answer.success);
  EXPECT_EQ(answer.count, 0U);
  EXPECT_EQ(answer.message, path_ + ":3: range_m is not in (0, 1e7]: -5");
  EXPECT_EQ(load(node, "").message, "path is empty");
  EXPECT_EQ(load(node, "absent").message, (folder_ / "absent: cannot be read: No such file or directory").string());
  std::filesystem::create_directory(folder_ / "a");
  EXPECT_EQ(save(node, "a").message, (folder_ / "a: cannot be written: it exists and is no regular file").string());
  EXPECT_EQ(save(node, "../b").message.substr(0, 29), "path must be the name of a fi");
  write("");
  EXPECT_EQ(load(node, "map.csv").message, "there are no clutter points to load");
  node.play(radars, 30.0, 60.0);
  for (const Request& told : node.told) replay.recorded.publish(told);
  replay.play(radars, 0.0, 60.0);
  const std::vector<Request> refusals(node.told.begin() + 1, node.told.end());
  ASSERT_EQ(refusals.size(), 4U);
  for (const Request& told : refusals) EXPECT_EQ(told.result, Request::REFUSED);
  EXPECT_TRUE(NodeGraph::bytesOf(replay.told) == NodeGraph::bytesOf(refusals));
}

// If this fails, the node runs without the map that it was told to begin with.
TEST_F(ClutterInterfaceTest, AFileThatIsMissingOrBadStopsTheNodeWithOneLine) {
  const auto complaint = [&] {
    try {
      NodeGraph node(with_file_);
    } catch (const tws_runtime::ParameterError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_EQ(complaint(), "adit: clutter_map: " + path_ + ": cannot be read: No such file or directory");
  write("*,1000,1\nr2,1000,1\n");
  EXPECT_EQ(complaint(), "adit: clutter_map: " + path_ + ":3: there is no radar 'r2'");
}

}  // namespace
}  // namespace adit_tracker
