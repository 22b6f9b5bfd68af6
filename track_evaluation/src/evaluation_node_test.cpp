#include <track_evaluation/evaluation_node.h>

#include <gtest/gtest.h>
#include <tws_msgs/CorrelatedTracks.h>
#include <tws_msgs/EvaluationSummary.h>
#include <tws_msgs/SsrPlots.h>
#include <tws_runtime/defaults.h>
#include <tws_runtime/local_graph.h>
#include <tws_runtime/parameters.h>
#include <tws_runtime/stray_stamps_test_helpers.h>

#include <cmath>
#include <map>
#include <sstream>

#include "message_test_helpers.h"

namespace track_evaluation {
namespace {

/// The node in a graph with somebody who publishes truth and tracks.
class Graph {
 public:
  explicit Graph(const std::string& parameters =
                     "{trackers: [adit], correlators: [correlated], secondary_radars: [ssr], from_s: 0}")
      : node(graph.addNode("evaluation", YAML::Load(parameters))), other_(graph.addNode("other")) {
    truth_ = other_.advertise<tws_msgs::Truth>("/truth");
    tracks_ = other_.advertise<tws_msgs::Tracks>("/adit/tracks");
    correlated_ = other_.advertise<tws_msgs::CorrelatedTracks>("/correlated/tracks");
    plots_ = other_.advertise<tws_msgs::SsrPlots>("/ssr/plots");
    geometry_msgs::TransformStamped site;
    site.header.frame_id = "map";
    site.child_frame_id = "a";
    site.transform.rotation.w = 1.0;
    other_.publishStaticTransform(site);
  }
  void truth(double time, std::vector<tws_msgs::TruthTarget> targets) {
    truth_.publish(truthMessage(time, std::move(targets)));
    graph.drain();
  }
  void tracks(double time, std::vector<tws_msgs::Track> tracks) {
    tracks_.publish(tracksAt(time, std::move(tracks)));
    graph.drain();
  }
  void plots(const tws_msgs::SsrPlots& message) {
    plots_.publish(message);
    graph.drain();
  }
  /// A correlated track under this identity, where the track stands.
  void correlated(double time, std::uint32_t identity, tws_msgs::Track track, std::uint16_t mode_3a) {
    tws_msgs::CorrelatedTracks message;
    message.header.stamp = ros::Time(time);
    message.header.frame_id = "map";
    message.radar = "a";
    message.tracks.resize(1);
    message.tracks[0].identity = identity;
    message.tracks[0].kind = tws_msgs::CorrelatedTrack::CORRELATED;
    message.tracks[0].track = std::move(track);
    message.tracks[0].track.mode_3a = mode_3a;
    correlated_.publish(message);
    graph.drain();
  }
  YAML::Node score(const std::string& tracker = "adit") {
    node.finish();
    std::ostringstream out;
    node.writeJson(out, "test");
    return YAML::Load(out.str())["trackers"][tracker];
  }
  std::uint64_t counted(const std::string& name) const {
    for (const auto& reading : graph.counters())
      if (reading.name == name) return reading.value;
    return 0;
  }

  std::ostringstream log;
  tws_runtime::LocalGraph graph{log};
  EvaluationNode node;

 private:
  tws_runtime::Bus& other_;
  tws_runtime::Publisher<tws_msgs::Truth> truth_;
  tws_runtime::Publisher<tws_msgs::Tracks> tracks_;
  tws_runtime::Publisher<tws_msgs::CorrelatedTracks> correlated_;
  tws_runtime::Publisher<tws_msgs::SsrPlots> plots_;
};

// If this fails, 2-D trackers look wrong by kilometres near the site.
TEST(EvaluationNode, ComparesATrackWithoutHeightInSlantRangeAndAzimuth) {
  Graph graph;
  graph.tracks(1.0, {firmTrack(5, 1.0, 5000, 0)});
  graph.truth(1.0, {aircraft(1, 3000, 0, 4000)});
  EXPECT_NEAR(graph.score()["metrics"]["rms_pos_m"].as<double>(), 0.0, 1e-9);
}

// If this fails, a picture that swaps codes or identities looks as good as one that does not.
TEST(EvaluationNode, OfACorrelatorCountsChangesOfIdentityAndWrongCodes) {
  Graph graph;
  auto target = aircraft(1, 5000, 0);
  target.mode_3a = 04101;
  for (const auto& [time, identity, code] : {std::tuple(1.0, 7u, 04101), {2.0, 7u, 04102}, {3.0, 8u, 04101}}) {
    graph.correlated(time, identity, firmTrack(99, time, 5000, 0), static_cast<std::uint16_t>(code));
    if (identity == 8u) {
      auto last = firmTrack(99, time, 5000, 0);
      last.state = tws_msgs::Track::DROPPED;
      graph.correlated(time, 7, last, 04101);
    }
    graph.truth(time, {target});
  }
  const YAML::Node score = graph.score("correlated");
  EXPECT_EQ(score["metrics"]["swaps"].as<int>(), 1);
  EXPECT_EQ(score["correlation"]["words_correlated"].as<int>(), 3);
  EXPECT_EQ(score["correlation"]["judged_words"].as<int>(), 3);
  EXPECT_EQ(score["correlation"]["miscorrelations"].as<int>(), 1);
  EXPECT_FALSE(graph.score()["correlation"]);
}

// If this fails, the same run scores differently live and offline.
TEST(EvaluationNode, TheOrderOfArrivalMakesNoDifference) {
  std::string outputs[2];
  for (const bool truth_first : {true, false}) {
    Graph graph;
    for (double time = 1.0; time < 20.0; time += 1.0) {
      const auto truth = [&] { graph.truth(time, {aircraft(1, 1000 * time, 0)}); };
      if (truth_first) truth();
      graph.tracks(time - 0.4, {firmTrack(5, time - 0.5, 1000 * time, 20)});
      graph.tracks(time + 0.4, {firmTrack(6, time + 0.3, 900 * time, 20)});
      if (!truth_first) truth();
    }
    std::ostringstream out;
    graph.node.finish();
    graph.node.writeJson(out, "test");
    const YAML::Node metrics = YAML::Load(out.str())["trackers"]["adit"]["metrics"];
    std::ostringstream text;
    text << metrics;
    outputs[truth_first ? 0 : 1] = text.str();
    EXPECT_EQ(metrics["epochs"].as<double>(), 19.0);
  }
  EXPECT_EQ(outputs[0], outputs[1]);
}

TEST(EvaluationNode, ASilentTrackerDoesNotHoldTheTruthUpForEver) {
  Graph graph;
  for (double time = 1.0; time < 20.0; time += 1.0) graph.truth(time, {aircraft(1, 0, 0)});
  EXPECT_GT(graph.node.epochs(), 10U);
  EXPECT_EQ(graph.score()["metrics"]["completeness"].as<double>(), 0.0);
}

TEST(EvaluationNode, BadTruthAndBadTracksAreCountedAndNothingElseIsLost) {
  Graph graph;
  graph.tracks(1.0, {firmTrack(5, 1.0, std::nan(""), 0), firmTrack(6, 1.0, 1000, 0)});
  graph.truth(1.0, {aircraft(1, std::nan(""), 0), aircraft(2, 1000, 0)});
  EXPECT_EQ(graph.score()["metrics"]["completeness"].as<double>(), 1.0);
  EXPECT_EQ(graph.counted("bad tracks"), 1U);
  EXPECT_EQ(graph.counted("bad truth"), 1U);
  EXPECT_NE(graph.log.str().find("position.x is nan"), std::string::npos) << graph.log.str();
}

TEST(EvaluationNode, TimeThatGoesBackBeginsANewRunAndTheRestOfTheOldOneIsDropped) {
  Graph graph;
  for (double time = 100.0; time < 110.0; time += 1.0) {
    graph.truth(time, {aircraft(1, 0, 0)});
    graph.tracks(time, {});
  }
  for (double time = 1.0; time < 4.0; time += 1.0) graph.truth(time, {aircraft(1, 0, 0)});
  graph.tracks(110.0, {firmTrack(7, 110.0, 0, 0)});
  graph.tracks(1.5, {firmTrack(5, 1.5, 0, 0)});
  EXPECT_EQ(graph.counted("new runs"), 0U) << "the truth alone does not decide";
  graph.truth(4.0, {aircraft(1, 0, 0)});
  EXPECT_EQ(graph.counted("new runs"), 1U);
  const YAML::Node metrics = graph.score()["metrics"];
  EXPECT_EQ(metrics["epochs"].as<double>(), 4.0) << "none of the new run is lost";
  EXPECT_NEAR(metrics["completeness"].as<double>(), 3.0 / 4.0, 1e-6);
}

// If this fails, one stamp that was damaged on its way wipes the score of a run.
TEST(EvaluationNode, StrayStampsEndNoRun) {
  Graph graph;
  for (int second = 0; second < 40; ++second) {
    const double time = 100.0 + second;
    graph.tracks(time, {firmTrack(5, time, 0, 0)});
    graph.truth(time, {aircraft(1, 0, 0)});
    if (second % 10 != 5) continue;
    const double stray = tws_runtime::strayed(ros::Time(time), tws_runtime::kStrays[second / 10]).toSec();
    graph.tracks(stray, {});
    graph.truth(stray, {});
  }
  EXPECT_EQ(graph.counted("new runs"), 0U);
  EXPECT_EQ(graph.counted("stray messages"), 8U);
  const YAML::Node metrics = graph.score()["metrics"];
  EXPECT_EQ(metrics["epochs"].as<double>(), 40.0);
  EXPECT_EQ(metrics["completeness"].as<double>(), 1.0);
}

TEST(EvaluationNode, ScoresByIdentityWithoutTruth) {
  Graph graph;
  for (int scan = 0; scan < 30; ++scan) {
    tws_msgs::SsrPlots message;
    message.header.stamp = ros::Time(1.0 + 4.0 * scan);
    message.plots.resize(1);
    message.plots[0].stamp = message.header.stamp;
    message.plots[0].range = 1000.0;
    message.plots[0].mode_3a = 01234;
    graph.plots(message);
    tws_msgs::Track track = firmTrack(5, 1.0 + 4.0 * scan, 0, 1000);
    track.range = 1000.0;
    if (scan % 2 == 0) graph.tracks(1.5 + 4.0 * scan, {track});
  }
  EXPECT_EQ(graph.node.identifiedPlots(), 30U);
  EXPECT_NEAR(graph.score()["identity"]["update_probability"].as<double>(), 0.5, 1e-9);
}

TEST(EvaluationNode, PublishesALatchedSummaryAndTiming) {
  Graph graph;
  std::map<std::string, tws_msgs::EvaluationSummary> received;
  graph.graph.advanceTo(ros::Time(1.0));
  graph.tracks(1.0, {firmTrack(5, 1.0, 1000, 0)});
  graph.truth(1.0, {aircraft(1, 1000, 0)});
  graph.tracks(2.0, {});
  graph.graph.advanceTo(ros::Time(20.0));
  tws_runtime::Bus& late = graph.graph.addNode("late");
  for (const std::string topic : {"/evaluation/summary", "/evaluation/timing"})
    late.subscribe<tws_msgs::EvaluationSummary>(
        topic, [&received, topic](const tws_msgs::EvaluationSummary& message) { received[topic] = message; });
  graph.graph.drain();
  const tws_msgs::EvaluationSummary& summary = received["/evaluation/summary"];
  EXPECT_EQ(summary.tracker, "adit");
  ASSERT_EQ(summary.names.size(), summary.values.size());
  EXPECT_NE(std::find(summary.names.begin(), summary.names.end(), "gospa_m"), summary.names.end());
  EXPECT_EQ(received["/evaluation/timing"].names.at(0), "plots_per_s");
}

TEST(EvaluationNode, RefusesAParameterItDoesNotKnowOrCannotUse) {
  for (const char* wrong : {"{cutof_m: 3}", "{cutoff_m: 0}", "{required_kinds: [bird]}", "{monitor_codes: ['8']}"})
    EXPECT_THROW(Graph{wrong}, tws_runtime::ParameterError) << wrong;
}

TEST(EvaluationNode, HasTheDefaultsOfTheShippedFileButForTheMonitors) {
  const YAML::Node shipped = tws_runtime::loadParameterFile(EVALUATION_CONFIG "/evaluation.yaml");
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  const auto departures =
      tws_runtime::departuresFromDefaults([&] { EvaluationNode node(graph.addNode("evaluation", shipped)); });
  ASSERT_EQ(departures.size(), 1U) << testing::PrintToString(departures);
  EXPECT_EQ(departures[0].substr(0, 13), "monitor_codes");
}

TEST(EvaluationNode, ReadsTheShippedParameters) {
  const std::string folder(EVALUATION_CONFIG);
  std::ostringstream log;
  tws_runtime::LocalGraph graph(log);
  EvaluationNode node(graph.addNode(
      "evaluation", tws_runtime::mergeParameters(tws_runtime::loadParameterFile(folder + "/evaluation.yaml"),
                                                 tws_runtime::loadParameterFile(folder + "/requirements.yaml"))));
  std::ostringstream out;
  node.writeJson(out, "");
  EXPECT_EQ(YAML::Load(out.str())["settings"]["cutoff_m"].as<double>(), 3000.0);
}

}  // namespace
}  // namespace track_evaluation
