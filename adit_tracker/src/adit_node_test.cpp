// The node in one process: operators, status, and what can be wrong with time.
#include <gtest/gtest.h>

#include <numeric>

#include "adit_node_test_helpers.h"

namespace adit_tracker {
namespace {

using Request = tws_msgs::OperatorRequest;

/// Eight aircraft for two minutes, and an operator who does one of each thing.
struct OperatedRun {
  explicit OperatedRun(const std::string& parameters = "{}") : node(parameters) {
    node.play(radars, 0.0, 50.0);
    const auto all = node.ask(Request::LIST_ALL);
    handed_off = all.tracks.at(1).number;
    node.ask(Request::HANDOFF, handed_off);
    node.ask(Request::DESIGNATE, all.tracks.at(2).number);
    node.play(radars, 50.0, 57.3);
    dropped = node.ask(Request::LIST_ALL).tracks.at(3).uid;
    node.drop({node.ask(Request::LIST_ALL).tracks.at(3).number});
    by_hand = node.initiate(NodeGraph::kEast - 30e3, 1e3).number;
    node.play(radars, 57.3, 120.0);
  }

  RadarSectors radars = flights(120.0, eightAircraft());
  NodeGraph node;
  std::uint32_t handed_off = 0, dropped = 0, by_hand = 0;
};

// If this fails, "why did it lose my aircraft?" is answered by another track's plot, or not at all.
TEST(AditNode, OnDemandItTellsWhatBecomesOfEachPlot) {
  const RadarSectors radars = flights(60.0, eightAircraft());
  NodeGraph silent, asked("{plot_fates: true}");
  silent.play(radars, 0.0, 60.0);
  asked.play(radars, 0.0, 60.0);
  EXPECT_TRUE(silent.fates.empty());
  std::map<std::pair<ros::Time, std::uint32_t>, double> ranges;  // of plots told with tracks, by time and track
  for (const tws_msgs::Track& update : asked.updates()) {
    if (update.state != tws_msgs::Track::DROPPED && !std::isnan(update.plot_range))
      ranges[{update.last_update, update.uid}] = update.plot_range;
  }
  std::size_t updated = 0;
  for (const tws_msgs::PlotFates& sector : asked.fates) {
    EXPECT_EQ(sector.tracker, "adit");
    EXPECT_EQ(sector.header.frame_id, sector.radar);
    EXPECT_EQ(sector.sector, sector.running_sector % 64);
    for (const tws_msgs::PlotFate& fate : sector.plots) {
      EXPECT_GT(fate.stamp, sector.header.stamp);
      if (fate.fate != tws_msgs::PlotFate::UPDATED) continue;
      ++updated;
      EXPECT_EQ((ranges[{fate.stamp, fate.track}]), fate.range) << fate.stamp;
    }
  }
  EXPECT_GT(updated, 80U);
}

// If this fails, a radar's Doppler does not come through from the message to the tracks.
TEST(AditNode, UsesTheRangeRatesOfRadarsThatMeasureThem) {
  const std::vector<TestTarget> targets = eightAircraft();
  RadarSectors radars = flights(20.0, targets);
  for (auto& sectors : radars) {
    for (tws::RadarSector& sector : sectors) {
      for (tws::Plot& plot : sector.plots) {
        const auto far = [&](const TestTarget& t) { return std::abs(t.range(plot.time) - plot.range); };
        const TestTarget& its = *std::min_element(targets.begin(), targets.end(),
                                                  [&](const auto& a, const auto& b) { return far(a) < far(b); });
        plot.range_rate = its.vx * std::sin(plot.azimuth) + its.vy * std::cos(plot.azimuth);
      }
    }
  }
  const std::string each = "{name: r0, range_rate_sigma_mps: 2}, {name: r1, period_s: 8, range_rate_sigma_mps: 2}";
  NodeGraph without, with("{radars: [" + each + "]}");
  without.play(radars, 0.0, 20.0);
  with.play(radars, 0.0, 20.0);
  const auto greatestStartingRate = [](const NodeGraph& node) {
    double greatest = 0.0;
    std::set<std::uint32_t> known;
    for (const tws_msgs::Track& update : node.updates())
      if (known.insert(update.uid).second) greatest = std::max(greatest, std::abs(update.range_rate));
    return greatest;
  };
  EXPECT_LT(greatestStartingRate(without), 1.0);
  EXPECT_GT(greatestStartingRate(with), 100.0);
}

// If this fails, a display cannot tell a sure track from a doubtful one, or a turn from straight flight.
TEST(AditNode, TracksBearTheirChanceOfExistenceAndOfTheirModels) {
  const RadarSectors radars = flights(60.0, eightAircraft());
  NodeGraph node;
  node.play(radars, 0.0, 60.0);
  for (const auto& [uid, track] : node.picture()) {
    EXPECT_GT(track.existence, 0.97F);
    ASSERT_EQ(track.model_probabilities.size(), 4U);
    EXPECT_GT(track.model_probabilities[0], 0.5F) << "all fly straight";
    EXPECT_NEAR(std::accumulate(track.model_probabilities.begin(), track.model_probabilities.end(), 0.0), 1.0, 1e-5);
  }
  EXPECT_EQ(node.picture().size(), 8U);
}

// If this fails, an operator's orders come back as done and are not.
TEST(AditNode, WhatAnOperatorOrdersShowsInTheTracks) {
  const OperatedRun run;
  bool dropped = false, started = false;
  for (const auto& update : run.node.updates()) {
    const double t = update.stamp.toSec() - kEpoch;
    const bool marked = (update.detection_bits & tws_msgs::Track::HANDED_OFF) != 0;
    EXPECT_TRUE(!marked || (update.number == run.handed_off && t > 49.0)) << t;
    EXPECT_TRUE(marked || update.number != run.handed_off || t < 51.0) << t;
    if (update.uid == run.dropped && update.state == tws_msgs::Track::DROPPED) dropped = true;
    EXPECT_TRUE(update.uid != run.dropped || !dropped || update.state == tws_msgs::Track::DROPPED);
    if (update.number == run.by_hand && t < 58.0 && std::abs(update.position.x + 25e3) < 1.0) started = true;
  }
  EXPECT_TRUE(dropped);
  EXPECT_TRUE(started);
  EXPECT_EQ(run.node.statuses.back().handed_off, std::vector<std::uint32_t>{run.handed_off});
  EXPECT_EQ(run.node.statuses.back().elevation_searches, 1U);
}

// If this fails, a bag does not tell what the operator did, or when.
TEST(AditNode, EachRequestAndItsEffectIsAMessage) {
  const OperatedRun run;
  ASSERT_EQ(run.node.told.size(), 7U);
  std::vector<int> requests;
  for (const Request& told : run.node.told) {
    requests.push_back(told.request);
    EXPECT_EQ(told.result, Request::OK);
    EXPECT_EQ(told.tracker, "adit");
    // Eight sectors of the slower radar, and no more, lie between an antenna and the tracks.
    const double asked = &told - run.node.told.data() < 3 ? 50.0 : 57.3;
    EXPECT_NEAR(told.header.stamp.toSec() - kEpoch, asked, 1.0);
  }
  EXPECT_EQ(requests, (std::vector<int>{Request::LIST_ALL, Request::HANDOFF, Request::DESIGNATE, Request::LIST_ALL,
                                        Request::LIST_ALL, Request::DROP, Request::INITIATE}));
  EXPECT_EQ(run.node.told[0].tracks.size(), 8U);
  EXPECT_EQ(run.node.told[1].tracks, std::vector<std::uint32_t>{run.handed_off});
  EXPECT_EQ(run.node.told[6].tracks, std::vector<std::uint32_t>{run.by_hand});
}

// If this fails, a recorded incident cannot be looked into: the replay goes another way than the run.
TEST(AditNode, AReplayRepeatsWhatTheOperatorDidByteByByte) {
  for (const char* set : {"{set: default}", "{set: nrl7952}"}) {
    const OperatedRun run(set);
    NodeGraph replay(set), idle(set);
    for (const Request& told : run.node.told) replay.recorded.publish(told);
    replay.play(run.radars, 0.0, 120.0);
    idle.play(run.radars, 0.0, 120.0);
    EXPECT_EQ(NodeGraph::bytesOf(replay.tracks), NodeGraph::bytesOf(run.node.tracks)) << set;
    EXPECT_EQ(NodeGraph::bytesOf(replay.told), NodeGraph::bytesOf(run.node.told)) << set;
    EXPECT_NE(NodeGraph::bytesOf(idle.tracks), NodeGraph::bytesOf(run.node.tracks)) << "the operator changed nothing";
    EXPECT_EQ(replay.count("late recorded requests") + replay.count("requests repeated with another effect"), 0U);
  }
}

TEST(AditNode, ARecordedRequestThatComesTooLateIsRepeatedAndCounted) {
  const OperatedRun run;
  NodeGraph replay;
  replay.play(run.radars, 0.0, 60.0);
  replay.recorded.publish(run.node.told[1]);
  replay.play(run.radars, 60.0, 120.0);
  EXPECT_EQ(replay.count("late recorded requests"), 1U);
  EXPECT_EQ(replay.statuses.back().handed_off, std::vector<std::uint32_t>{run.handed_off});
}

TEST(AditNode, RequestsThatMakeNoSenseAreRefusedInWords) {
  OperatedRun run;
  EXPECT_EQ(run.node.ask(Request::HANDOFF, 4242).message, "there is no track 4242");
  EXPECT_EQ(run.node.ask(Request::HANDOFF, 4242).result, Request::REFUSED);
  EXPECT_EQ(run.node.ask(99).message, "request 99 is unknown");
  EXPECT_NE(run.node.ask(Request::LIST_AZIMUTH).message, "");
  EXPECT_EQ(run.node.ask(Request::INITIATE).result, Request::REFUSED);
  const auto answer = run.node.drop({4242, run.handed_off, 4243});
  EXPECT_FALSE(answer.success);
  EXPECT_EQ(answer.message, "there is no track 4242; there is no track 4243");
  EXPECT_NE(run.node.initiate(1e3, 1e3, "nowhere").message, "");
}

TEST(AditNode, BeforeTheFirstSectorItIsBusyAndSaysSo) {
  NodeGraph node;
  const auto answer = node.ask(Request::LIST_ALL);
  EXPECT_EQ(answer.result, Request::BUSY);
  EXPECT_EQ(answer.message, "busy: no sector has been processed yet");
  ASSERT_EQ(node.told.size(), 1U);
  EXPECT_EQ(node.told[0].result, Request::BUSY);
}

// If this fails, RViz's Publish Point does nothing, or starts tracks unasked.
TEST(AditNode, APointByHandStartsATrackOnlyWhereTheParameterNamesItsTopic) {
  const RadarSectors radars = flights(30.0, eightAircraft());
  for (const bool named : {false, true}) {
    NodeGraph node(named ? "{point_topic: /clicked_point}" : "{}");
    node.play(radars, 0.0, 20.0);
    geometry_msgs::PointStamped point;
    point.header.frame_id = "r0";  // 5 km east of the map's origin
    point.point.x = -30e3;
    node.points.publish(point);
    node.graph.drain();
    EXPECT_EQ(node.told.size(), named ? 1U : 0U);
    for (const Request& told : node.told) EXPECT_NEAR(told.position.x, -25e3, 1e-6);
  }
}

// If this fails, nobody sees how the tracker is doing. Ten turns of the slower radar, whose sector 61 is processed in
// each.
TEST(AditNode, ItsStatusComesOnceAScanAndCountsWhatThereIs) {
  NodeGraph node;
  node.play(flights(80.4, eightAircraft()), 0.0, 80.4);
  ASSERT_EQ(node.statuses.size(), 9U);
  const tws_msgs::TrackerStatus& status = node.statuses.back();
  EXPECT_EQ(status.tracker, "adit");
  EXPECT_NEAR(status.header.stamp.toSec() - kEpoch, 0.5 + 8.0 * (8 + 61.0 / 64.0), 1e-6);
  EXPECT_EQ(status.firm_tracks, 8U);
  EXPECT_EQ(status.tracks, 8U);
  EXPECT_EQ(status.radars, (std::vector<std::string>{"r0", "r1"}));
  // The four of the method, and one more when both radars' sectors become ready together.
  EXPECT_EQ(status.sector_lag.size(), 2U);
  for (const std::uint32_t lag : status.sector_lag) EXPECT_TRUE(lag == 4 || lag == 5) << lag;
  EXPECT_EQ(status.capacity, 100000U);
  EXPECT_EQ(status.skipped_sectors + status.late_detections + status.rejected_detections + status.refused_tracks, 0U);
  EXPECT_GT(status.operator_calls, 64U);
}

// If this fails, aircraft are missing without a word; or those that are tracked are given up for new ones.
TEST(AditNode, BeforeItIsFullItWarnsAndThenRefusesNewTracksAndKeepsTheOldOnes) {
  NodeGraph node("{capacity: 11}");
  std::vector<TestTarget> targets = eightAircraft();
  const auto late = [&](double azimuth, double from) {
    TestTarget target{90e3 * std::sin(azimuth), 90e3 * std::cos(azimuth), 150.0, 0.0};
    target.from = from;
    targets.push_back(target);
  };
  for (const double azimuth : {1.2, 2.0, 2.8, 3.6}) late(azimuth, 60.0);
  const RadarSectors radars = flights(120.0, targets);
  node.play(radars, 0.0, 58.0);
  const std::set<std::uint32_t> before = node.confirmed();
  EXPECT_EQ(before.size(), 8U);
  EXPECT_EQ(node.count("capacity warnings") + node.count("refused tracks"), 0U);
  std::uint64_t warnings_at_refusal = 0;
  for (double t = 58.0; t < 120.0; t += 0.05) {
    node.play(radars, t, t + 0.05);
    if (node.count("refused tracks") > 0 && warnings_at_refusal == 0)
      warnings_at_refusal = node.count("capacity warnings");
  }
  EXPECT_GT(node.count("refused tracks"), 0U);
  EXPECT_EQ(warnings_at_refusal, 1U);
  const std::set<std::uint32_t> after = node.confirmed();
  EXPECT_TRUE(std::includes(after.begin(), after.end(), before.begin(), before.end()));
  EXPECT_GT(node.statuses.back().refused_tracks, 0U);
}

}  // namespace
}  // namespace adit_tracker
